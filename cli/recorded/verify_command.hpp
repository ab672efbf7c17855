// `beespace verify`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/recorded/path_limits.hpp"

#include <beespace/verify.hpp>

#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

struct VerifyRequest {
  MovingRequest moving;
  VerifyOptions check{.clearance_m = 1.0};  // the threshold and the obstacles are not there yet
  std::string obstacles;                    // a file; empty for none
  std::optional<double> max_gap_s;          // absent: from the data
  AskedLimits limits;                       // those of `check` are among them
  std::vector<std::string> skipped_limits;  // that a show declares and that need not be looked at
};

Command verify_command();

Result<ExitCode> run_verify(const VerifyRequest& request);

}  // namespace beespace::cli
