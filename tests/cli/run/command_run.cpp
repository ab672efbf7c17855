#include "tests/cli/run/command_run.hpp"

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace beespace::cli_test {
namespace {

struct Pipe {
  int read_end = -1;
  int write_end = -1;
};

// Closed in the child when it starts the command; only what is dup2-ed stays.
Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) std::abort();
  return {ends[0], ends[1]};
}

Pipe make_terminal() {
  int master = -1;
  int slave = -1;
  if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) std::abort();
  fcntl(master, F_SETFD, FD_CLOEXEC);
  fcntl(slave, F_SETFD, FD_CLOEXEC);
  return {master, slave};
}

void close_if_open(int& descriptor) {
  if (descriptor >= 0) close(descriptor);
  descriptor = -1;
}

void limit(decltype(RLIMIT_AS) resource, std::size_t bytes) {
  if (bytes == 0) return;
  const rlimit most{bytes, bytes};
  setrlimit(resource, &most);
}

constexpr int kCannotStart = 127;

// From here on the permissions of files count, as they do not for root.
void give_up_privileges() {
  constexpr unsigned kUnprivileged = 65'534;
  if (geteuid() != 0) return;
  if (setgroups(0, nullptr) != 0 || setgid(kUnprivileged) != 0 || setuid(kUnprivileged) != 0) {
    _exit(kCannotStart);
  }
}

[[noreturn]] void become_command(const Arguments& arguments, int in, int out, int error,
                                 bool unprivileged) {
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(error, STDERR_FILENO);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGXCPU, SIGXFSZ, SIGPIPE}) {
    std::signal(number, SIG_DFL);
  }
  std::string command = BEESPACE_COMMAND;
  std::vector<char*> pointers = {command.data()};
  std::vector<std::string> copies = arguments;
  for (std::string& argument : copies) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  // Opened first: the folder of the build may be closed to others.
  const int program = open(command.c_str(), O_RDONLY | O_CLOEXEC);
  if (unprivileged) give_up_privileges();
  fexecve(program, pointers.data(), environ);
  _exit(kCannotStart);
}

// Reads both to their ends; false where that takes too long. A terminal whose other side is closed
// reports an error instead.
bool drain(int out, int error, Finished& finished, int timeout_ms) {
  std::array<pollfd, 2> waiting{{{out, POLLIN, 0}, {error, POLLIN, 0}}};
  std::array<std::string*, 2> texts = {&finished.out, &finished.err};
  std::array<char, 65536> block{};
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    const int ready = poll(waiting.data(), waiting.size(), timeout_ms);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].fd < 0 || waiting[i].revents == 0) continue;
      const ssize_t count = read(waiting[i].fd, block.data(), block.size());
      if (count > 0) {
        texts[i]->append(block.data(), static_cast<std::size_t>(count));
      } else {
        waiting[i].fd = -1;
      }
    }
  }
  return true;
}

}  // namespace

bool has_terminals() {
  int master = -1;
  int slave = -1;
  if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) return false;
  close(master);
  close(slave);
  return true;
}

Running::Running(const Arguments& arguments, const Surroundings& surroundings) {
  using Output = Surroundings::Output;
  std::signal(SIGPIPE, SIG_IGN);  // of this test program: the command may not read its input
  Pipe in = make_pipe();
  if (surroundings.input_on_terminal) {
    close_if_open(in.read_end);
    close_if_open(in.write_end);
    const Pipe terminal = make_terminal();
    in = {terminal.write_end, terminal.read_end};
  }
  Pipe out = make_pipe();
  Pipe error = surroundings.error_on_terminal ? make_terminal() : make_pipe();
  if (surroundings.output == Output::kFile) {
    close_if_open(out.write_end);
    out.write_end = open(surroundings.file.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT, 0666);
  }
  if (surroundings.output == Output::kClosedPipe) close_if_open(out.read_end);
  process_ = fork();
  if (process_ < 0) std::abort();
  if (process_ == 0) {
    limit(RLIMIT_AS, surroundings.memory_bytes);
    limit(RLIMIT_FSIZE, surroundings.file_bytes);
    become_command(arguments, in.read_end, out.write_end, error.write_end,
                   surroundings.unprivileged);
  }
  close_if_open(in.read_end);
  close_if_open(out.write_end);
  close_if_open(error.write_end);
  input_ = in.write_end;
  output_ = out.read_end;
  error_ = error.read_end;
}

Running::~Running() {
  if (process_ >= 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close_if_open(input_);
  close_if_open(output_);
  close_if_open(error_);
}

void Running::send(std::string_view input) const {
  while (!input.empty()) {
    const ssize_t count = write(input_, input.data(), input.size());
    if (count <= 0) return;  // the command has ended already
    input.remove_prefix(static_cast<std::size_t>(count));
  }
}

void Running::close_input() {
  close_if_open(input_);
}

void Running::signal(int number) const {
  kill(process_, number);
}

namespace {

std::string line_from(int descriptor) {
  constexpr int kPatience_ms = 10'000;
  std::string line;
  char next = 0;
  pollfd waiting{descriptor, POLLIN, 0};
  while (poll(&waiting, 1, kPatience_ms) > 0 && read(descriptor, &next, 1) == 1 && next != '\n') {
    line += next;
  }
  return line;
}

}  // namespace

std::string Running::read_line() const {
  return line_from(output_);
}

std::string Running::read_error_line() const {
  return line_from(error_);
}

Finished Running::finish() {
  constexpr int kPatience_ms = 60'000;
  Finished finished;
  if (!drain(output_, error_, finished, kPatience_ms)) kill(process_, SIGKILL);
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  if (WIFEXITED(status)) finished.exit_code = WEXITSTATUS(status);
  return finished;
}

namespace {

Finished feed_and_finish(Running& running, std::string_view input) {
  std::thread feeder([&running, input] {
    running.send(input);
    running.close_input();
  });
  const Finished finished = running.finish();
  feeder.join();
  return finished;
}

}  // namespace

Finished run(const Arguments& arguments, std::string_view input, const Surroundings& surroundings) {
  Running running(arguments, surroundings);
  return feed_and_finish(running, input);
}

Finished run_on_terminal(const Arguments& arguments, const std::string& no_colour) {
  setenv("TERM", "xterm", 1);
  if (no_colour.empty()) {
    unsetenv("NO_COLOR");
  } else {
    setenv("NO_COLOR", no_colour.c_str(), 1);
  }
  Surroundings watched;
  watched.error_on_terminal = true;
  Running running(arguments, watched);
  unsetenv("NO_COLOR");
  return feed_and_finish(running, {});
}

}  // namespace beespace::cli_test
