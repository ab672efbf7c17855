// `beespace export`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/show/show_request.hpp"
#include "report/placement.hpp"

#include <optional>
#include <string>

namespace beespace::cli {

struct ExportRequest {
  ShowRequest show;
  std::string format;                          // empty: by the ending of the output
  std::optional<report::Placement> placement;  // of positions in metres
  std::string obstacles;                       // empty: none
};

Command export_command();

Result<ExitCode> run_export(const ExportRequest& request);

}  // namespace beespace::cli
