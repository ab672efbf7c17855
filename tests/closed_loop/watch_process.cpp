#include "tests/closed_loop/watch_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>

namespace beespace::closed_loop {
namespace {

constexpr int kMinute_ms = 60'000;

struct Pipe {
  int read_end = -1;
  int write_end = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) std::abort();
  return {ends[0], ends[1]};
}

void close_if_open(int& descriptor) {
  if (descriptor >= 0) close(descriptor);
  descriptor = -1;
}

// False at its end.
bool read_into(std::string& text, int& descriptor) {
  std::array<char, 65536> block{};
  const ssize_t count = read(descriptor, block.data(), block.size());
  if (count <= 0) {
    close_if_open(descriptor);
    return false;
  }
  text.append(block.data(), static_cast<std::size_t>(count));
  return true;
}

}  // namespace

WatchProcess::WatchProcess(const std::string& command, const std::vector<std::string>& arguments) {
  std::signal(SIGPIPE, SIG_IGN);
  Pipe in = make_pipe();
  Pipe out = make_pipe();
  Pipe error = make_pipe();
  std::vector<std::string> words = {command};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  process_ = fork();
  if (process_ < 0) std::abort();
  if (process_ == 0) {
    dup2(in.read_end, STDIN_FILENO);
    dup2(out.write_end, STDOUT_FILENO);
    dup2(error.write_end, STDERR_FILENO);
    std::signal(SIGPIPE, SIG_DFL);
    execv(command.c_str(), pointers.data());
    _exit(127);
  }
  close_if_open(in.read_end);
  close_if_open(out.write_end);
  close_if_open(error.write_end);
  input_ = in.write_end;
  output_ = out.read_end;
  error_ = error.read_end;
  fcntl(input_, F_SETFL, O_NONBLOCK);
}

WatchProcess::~WatchProcess() {
  if (process_ >= 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close_if_open(input_);
  close_if_open(output_);
  close_if_open(error_);
}

void WatchProcess::send(std::string_view text) {
  while (!text.empty() && input_ >= 0) {
    const ssize_t count = write(input_, text.data(), text.size());
    if (count > 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    if (errno != EAGAIN && errno != EINTR) {
      close_if_open(input_);
      return;
    }
    read_what_there_is(1);
  }
}

void WatchProcess::read_what_there_is(int patience_ms) {
  std::array<pollfd, 2> waiting{{{output_, POLLIN, 0}, {error_, POLLIN, 0}}};
  if (poll(waiting.data(), waiting.size(), patience_ms) <= 0) return;
  if (waiting[0].revents != 0) read_into(said_, output_);
  if (waiting[1].revents != 0) read_into(errors_, error_);
}

bool WatchProcess::next_line(std::string& line, int patience_ms) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::milliseconds(patience_ms);
  for (;;) {
    const std::size_t end = said_.find('\n', taken_);
    if (end != std::string::npos) {
      line.assign(said_, taken_, end - taken_);
      taken_ = end + 1;
      return true;
    }
    said_.erase(0, taken_);
    taken_ = 0;
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (output_ < 0 || left < 0) return false;
    read_what_there_is(static_cast<int>(left) + 1);
  }
}

int WatchProcess::finish() {
  close_if_open(input_);
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::milliseconds(kMinute_ms);
  while ((output_ >= 0 || error_ >= 0) && Clock::now() < until) read_what_there_is(100);
  if (output_ >= 0 || error_ >= 0) kill(process_, SIGKILL);
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace beespace::closed_loop
