// The command line of `beespace detect`, checked: a request that makes sense, or what does not.
#pragma once

#include "cli/detect/detect_command.hpp"
#include "cli/detect/detection.hpp"

#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

// Errors: kInvalidArgument, kInvalidThreshold.
Result<DetectRequest> request_of(const DetectOptions& options);

// An error of the command line, with the way to the help.
Error detect_usage_error(std::string message);

}  // namespace beespace::cli
