// `beespace report`: its options, and what it does with them.
#pragma once

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
void add_page_input_options(CLI::App& command, ReportOptions& options);

// Adds the subcommand to the command; `options` must outlive the parsing.
CLI::App* add_report_command(CLI::App& command, ReportOptions& options);

ExitCode run_report(const ReportOptions& options);

}  // namespace beespace::cli
