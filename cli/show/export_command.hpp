// `beespace export`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/show/seen_request.hpp"

#include <string>

namespace beespace::cli {

struct ExportRequest {
  SeenRequest seen;
  std::string format;  // empty: by the ending of the output
};

Command export_command();

Result<ExitCode> run_export(const ExportRequest& request);

}  // namespace beespace::cli
