// `beespace export`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"
#include "cli/show/show_request.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct ExportOptions {
  SceneOptions scene;
  std::string format;
};

// `options` must outlive it.
Command export_command(ExportOptions& options);

ExitCode run_export(const ExportOptions& options);

}  // namespace beespace::cli
