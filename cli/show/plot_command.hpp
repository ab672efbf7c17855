// `beespace plot`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
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

// `options` must outlive it.
Command plot_command(PlotOptions& options);

ExitCode run_plot(const PlotOptions& options);

}  // namespace beespace::cli
