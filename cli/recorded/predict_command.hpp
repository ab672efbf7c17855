// `beespace predict`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/input/moving_options.hpp"

#include <optional>

namespace beespace::cli {

struct PredictRequest {
  MovingRequest moving;
  std::optional<double> horizon_s = {};  // absent: analysis::usual_horizon_s()
  double max_age_s = 30.0;
};

Command predict_command();

Result<ExitCode> run_predict(const PredictRequest& request);

}  // namespace beespace::cli
