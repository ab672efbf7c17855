#include "cli/standard_output.hpp"

#include "cli/terminal.hpp"

#include <cerrno>
#include <cstdio>

namespace beespace::cli {

ExitCode print(const std::string& text) {
  const bool complete = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  if (complete) return ExitCode::kFine;
  if (errno == EPIPE) return ExitCode::kPipeClosed;
  say_error("cannot write to standard output");
  return ExitCode::kSystem;
}

}  // namespace beespace::cli
