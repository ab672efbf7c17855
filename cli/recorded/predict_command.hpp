// `beespace predict`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"
#include "cli/input/moving_options.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct PredictCommandOptions {
  MovingOptions moving;
  std::string horizon = "60";
  std::string max_age = "30";
};

// `options` must outlive it.
Command predict_command(PredictCommandOptions& options);

ExitCode run_predict(const PredictCommandOptions& options);

}  // namespace beespace::cli
