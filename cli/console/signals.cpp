#include "cli/console/signals.hpp"

#include "io/bytes/atomic_output.hpp"

#include <unistd.h>
#include <csignal>
#include <initializer_list>
#include <string_view>

namespace beespace::cli {
namespace {

constexpr int kSignalExitCode = 128;

// Only async-signal-safe calls; the process ends here, so errno need not be kept.
extern "C" void leave(int signal) {
  io::discard_open_outputs_in_signal_handler();
  _exit(kSignalExitCode + signal);
}

// What is read where it lies in a file is gone when the file becomes shorter.
extern "C" void leave_without_input(int /*signal*/) {
  io::discard_open_outputs_in_signal_handler();
  constexpr std::string_view kMessage =
      "beespace: error: a file became shorter while it was read, or its disk failed; read a copy "
      "that stays as it is\n";
  // Nothing can be done where that is not read either.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  _exit(static_cast<int>(ExitCode::kSystem));
}

volatile std::sig_atomic_t end_wanted = 0;

extern "C" void ask_for_end(int signal) {
  if (end_wanted != 0) leave(signal);
  end_wanted = signal;
}

// Unless the one who started the program had the signal ignored.
void handle(int signal, void (*handler)(int)) {
  struct sigaction current {};
  sigaction(signal, nullptr, &current);
  if (current.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = handler;
  sigfillset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void handle_signals() {
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  // Writing then fails with an error that is said: EPIPE, EFBIG.
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGXCPU}) {
    handle(signal, leave);
  }
  handle(SIGBUS, leave_without_input);
}

void let_interruption_wait() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, ask_for_end);
}

bool interrupted() {
  return end_wanted != 0;
}

ExitCode exit_code_of_interruption() {
  return static_cast<ExitCode>(kSignalExitCode + end_wanted);
}

}  // namespace beespace::cli
