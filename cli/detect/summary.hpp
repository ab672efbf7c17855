// What a person wants to know after a run, on a few aligned lines.
#pragma once

#include "cli/detect/detection.hpp"

#include <string>

namespace beespace::cli {

std::string summary(const Inputs& inputs, const Detection& detection, const DetectRequest& request);

}  // namespace beespace::cli
