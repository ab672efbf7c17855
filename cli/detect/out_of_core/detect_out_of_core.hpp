// `beespace detect --memory`: files that are larger than the memory that may be used.
#pragma once

#include "cli/detect/detection.hpp"

#include <beespace/result.hpp>

namespace beespace::cli {

// What does not go together with --memory.
Status check_out_of_core(const DetectRequest& request);

// The exit code, or what went wrong.
Result<ExitCode> run_detect_out_of_core(const DetectRequest& request);

}  // namespace beespace::cli
