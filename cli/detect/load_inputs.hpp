// Reading what a detection is about: the swarm, and the others where there are some.
#pragma once

#include "cli/console/progress_bar.hpp"
#include "cli/detect/detection.hpp"

#include <beespace/result.hpp>

namespace beespace::cli {

// Errors: those of reading, and kUnsupportedFormat for a recording; kInvalidArgument where the two
// are in different frames, or the form of the answer needs another one.
Result<Inputs> load_inputs(const DetectRequest& request, ProgressBar& progress);

}  // namespace beespace::cli
