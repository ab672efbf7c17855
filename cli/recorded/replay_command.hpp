// `beespace replay`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"
#include "cli/input/live_options.hpp"
#include "cli/input/moving_options.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct ReplayOptions {
  MovingOptions moving;
  std::string report = "conflicts";
  std::string max_gap;
  std::string tolerance = "0.001";
  std::string every;
  LiveOptions live;
};

// `options` must outlive it.
Command replay_command(ReplayOptions& options);

ExitCode run_replay(const ReplayOptions& options);

}  // namespace beespace::cli
