// `beespace predict`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/input/moving_options.hpp"

namespace beespace::cli {

struct PredictRequest {
  MovingRequest moving;
  double horizon_s = 60.0;
  double max_age_s = 30.0;
};

Command predict_command();

Result<ExitCode> run_predict(const PredictRequest& request);

}  // namespace beespace::cli
