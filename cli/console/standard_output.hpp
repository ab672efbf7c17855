// Text to standard output at once, for what is not an answer in blocks.
#pragma once

#include "cli/console/exit_code.hpp"

#include <string>
#include <string_view>

namespace beespace::cli {

// Whole, or what to end with: kPipeClosed when the reader is gone, kSystem after saying so
// otherwise.
ExitCode print(const std::string& text);

// For those who go on: 0, or the errno of what went wrong. A signal that has been let wait ends
// a write that waits for the reader: EINTR, at once or after a second.
int write_out(std::string_view text);

}  // namespace beespace::cli
