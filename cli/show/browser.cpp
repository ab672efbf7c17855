#include "cli/show/browser.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <thread>

namespace beespace::cli {
namespace {

bool is_set(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): no thread sets any
  return value != nullptr && *value != '\0';
}

// In a group of its own, with the signals handled as they are anywhere; what it says is not for
// here.
std::optional<pid_t> started(const std::string& address) {
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) return std::nullopt;
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", O_RDWR, 0);
  }
  posix_spawnattr_t attributes;
  if (posix_spawnattr_init(&attributes) != 0) {
    posix_spawn_file_actions_destroy(&actions);
    return std::nullopt;
  }
  sigset_t as_anywhere;
  sigemptyset(&as_anywhere);
  for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&as_anywhere, signal);
  posix_spawnattr_setsigdefault(&attributes, &as_anywhere);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           static_cast<short>(POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP));
  std::string program = "xdg-open";
  std::string argument = address;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "xdg-open", &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return std::nullopt;
  return child;
}

// Waits for its end, so that nothing of it is left behind. Who has not failed by then stays with
// the browser.
void watch(pid_t child, const std::function<void(bool)>& tell) {
  constexpr std::chrono::seconds kPatience(3);
  constexpr std::chrono::milliseconds kPause(10);
  const auto until = std::chrono::steady_clock::now() + kPatience;
  int status = 0;
  pid_t ended = waitpid(child, &status, WNOHANG);
  while (ended == 0 && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(kPause);
    ended = waitpid(child, &status, WNOHANG);
  }
  tell(ended == 0 || (ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0));
  if (ended == 0) waitpid(child, &status, 0);
}

}  // namespace

void open_in_browser(const std::string& address, const std::function<void(bool opened)>& tell) {
  const bool desktop = is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") || is_set("BROWSER");
  const auto child = desktop ? started(address) : std::nullopt;
  if (!child) {
    tell(false);
    return;
  }
  try {
    std::thread(watch, *child, tell).detach();
  } catch (const std::system_error&) {  // no more threads
    tell(true);
  }
}

}  // namespace beespace::cli
