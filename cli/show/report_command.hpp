// `beespace report`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/show/show_request.hpp"

#include <string>

namespace beespace::cli {

struct ReportRequest {
  ShowRequest show;
  std::string compare;    // empty: nothing
  std::string fleet_log;  // the same
  std::string obstacles;  // the same
};

// What to read, what to compare it with, and what is too close: of `report` and `view`.
void add_page_input_options(Command& command, ReportRequest& request);

Command report_command();

Result<ExitCode> run_report(const ReportRequest& request);

}  // namespace beespace::cli
