#include "cli/standard_output.hpp"

#include "cli/signals.hpp"
#include "cli/terminal.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>

namespace beespace::cli {

ExitCode print(const std::string& text) {
  const bool complete = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  if (complete) return ExitCode::kFine;
  if (errno == EPIPE) return ExitCode::kPipeClosed;
  say_error("cannot write to standard output");
  return ExitCode::kSystem;
}

int write_out(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
    if (!text.empty() && interrupted()) return EINTR;
  }
  return 0;
}

}  // namespace beespace::cli
