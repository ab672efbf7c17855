// `beespace plot`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/show/show_request.hpp"

#include <string>

namespace beespace::cli {

struct PlotRequest {
  ShowRequest show;
  std::string title;  // empty: the name of the input
  unsigned width = 1200;
};

Command plot_command();

Result<ExitCode> run_plot(const PlotRequest& request);

}  // namespace beespace::cli
