// `beespace replay`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/input/live_options.hpp"
#include "cli/input/moving_options.hpp"

#include <optional>
#include <string>

namespace beespace::cli {

struct ReplayRequest {
  MovingRequest moving;
  std::string report = "conflicts";
  std::optional<double> max_gap_s;  // absent: from the data
  double tolerance_m = 0.001;
  double every_s = 1.0;
  LiveRequest live;
};

Command replay_command();

Result<ExitCode> run_replay(const ReplayRequest& request);

}  // namespace beespace::cli
