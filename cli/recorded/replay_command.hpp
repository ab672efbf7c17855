// `beespace replay`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/input/live_options.hpp"
#include "cli/input/moving_options.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace beespace::cli {

struct ReplayRequest {
  MovingRequest moving;
  std::string report = "conflicts";
  std::optional<double> max_gap_s;  // absent: from the data
  double tolerance_m = 0.001;
  bool straight = false;  // velocities are not looked at
  double every_s = 1.0;
  LiveRequest live;
  std::optional<std::uint64_t> memory_bytes;  // absent: all that it takes
  std::string temporary;                      // the folder of temporary files, with memory_bytes
};

Command replay_command();

Result<ExitCode> run_replay(const ReplayRequest& request);

}  // namespace beespace::cli
