// `beespace replay`: its options, and what it does with them.
#pragma once

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

// Adds the subcommand to the command; `options` must outlive the parsing.
CLI::App* add_replay_command(CLI::App& command, ReplayOptions& options);

ExitCode run_replay(const ReplayOptions& options);

}  // namespace beespace::cli
