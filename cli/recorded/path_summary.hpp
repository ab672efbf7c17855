// What `beespace verify` found along curves, as the lines of a summary.
#pragma once

#include "cli/input/moving_options.hpp"
#include "cli/recorded/path_findings.hpp"

#include <string>

namespace beespace::cli {

std::string verify_summary(const PathFindings& findings, const MovingRequest& request);

}  // namespace beespace::cli
