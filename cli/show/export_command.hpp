// `beespace export`: its options, and what it does with them.
#pragma once

#include "cli/console/exit_code.hpp"
#include "cli/show/show_request.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct ExportOptions {
  SceneOptions scene;
  std::string format;
};

// Adds the subcommand to the command; `options` must outlive the parsing.
CLI::App* add_export_command(CLI::App& command, ExportOptions& options);

ExitCode run_export(const ExportOptions& options);

}  // namespace beespace::cli
