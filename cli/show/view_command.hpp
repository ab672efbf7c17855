// `beespace view`: its options, and what it does with them.
#pragma once

#include "cli/console/exit_code.hpp"
#include "cli/show/report_command.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct ViewOptions {
  ReportOptions report;
  std::string port = "0";
  bool no_open = false;
};

// Adds the subcommand to the command; `options` must outlive the parsing.
CLI::App* add_view_command(CLI::App& command, ViewOptions& options);

ExitCode run_view(const ViewOptions& options);

}  // namespace beespace::cli
