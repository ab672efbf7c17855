// `beespace report`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"
#include "cli/show/show_request.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct ReportOptions {
  SceneOptions scene;
  std::string compare;
};

// What to read, what to compare it with, and what is too close: of `report` and `view`.
void add_page_input_options(Command& command, ReportOptions& options);

// `options` must outlive it.
Command report_command(ReportOptions& options);

ExitCode run_report(const ReportOptions& options);

}  // namespace beespace::cli
