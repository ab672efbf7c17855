// `beespace verify`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"
#include "cli/input/moving_options.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct VerifyCommandOptions {
  MovingOptions moving;
  std::string max_speed;
  std::string max_acceleration;
  std::string obstacles;
  std::string clearance;
  std::string max_gap;
  bool straight = false;
};

// `options` must outlive it.
Command verify_command(VerifyCommandOptions& options);

ExitCode run_verify(const VerifyCommandOptions& options);

}  // namespace beespace::cli
