// Text to standard output at once, for what is not an answer in blocks.
#pragma once

#include "cli/exit_code.hpp"

#include <string>

namespace beespace::cli {

// Whole, or what to end with: kPipeClosed when nobody reads, kSystem after saying so otherwise.
ExitCode print(const std::string& text);

}  // namespace beespace::cli
