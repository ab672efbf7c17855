// The search of one detection: who is at risk, and what the report asks beyond that.
#pragma once

#include "cli/detect/detection.hpp"

#include <beespace/result.hpp>

namespace beespace::cli {

// The timings stay empty. Errors: those of the searches; of kTooManyResults in the command's words.
Result<Detection> search(const Inputs& inputs, const DetectRequest& request);

// What is said beyond --max-results, which is what can be turned here.
Error too_many_results(const DetectRequest& request);

}  // namespace beespace::cli
