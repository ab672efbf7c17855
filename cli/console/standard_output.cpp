#include "cli/console/standard_output.hpp"

#include "cli/console/signals.hpp"
#include "cli/console/terminal.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
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
  constexpr int kPatience = 1000;
  while (!text.empty()) {
    std::size_t most = text.size();
    if (interrupted()) {
      // What is still to be said must not wait for long: a pipe that is ready takes this much.
      pollfd waiting{STDOUT_FILENO, POLLOUT, 0};
      if (::poll(&waiting, 1, kPatience) == 0) return EINTR;
      most = std::min<std::size_t>(most, PIPE_BUF);
    }
    const ssize_t written = ::write(STDOUT_FILENO, text.data(), most);
    if (written < 0 && errno != EINTR) return errno;
    if (written < 0 && interrupted()) return EINTR;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace beespace::cli
