// `beespace view`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
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

// `options` must outlive it.
Command view_command(ViewOptions& options);

ExitCode run_view(const ViewOptions& options);

}  // namespace beespace::cli
