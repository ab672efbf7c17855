// `beespace plot`: its options, and what it does with them.
#pragma once

#include "cli/console/exit_code.hpp"
#include "cli/show/show_request.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct PlotOptions {
  SceneOptions scene;
  std::string title;
  std::string width = "1200";
};

// Adds the subcommand to the command; `options` must outlive the parsing.
CLI::App* add_plot_command(CLI::App& command, PlotOptions& options);

ExitCode run_plot(const PlotOptions& options);

}  // namespace beespace::cli
