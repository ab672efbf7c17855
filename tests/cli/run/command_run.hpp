// Starts the built command as a shell would, and returns its output.
#pragma once

#include <sys/types.h>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli_test {

struct Finished {
  int exit_code = -1;  // -1 when a signal killed it
  std::string out;
  std::string err;
};

using Arguments = std::vector<std::string>;

// Whether this system can make terminals; a bare chroot without /dev/pts cannot.
bool has_terminals();

// The same with standard error on a terminal, and NO_COLOR set to `no_colour` unless it is empty.
Finished run_on_terminal(const Arguments& arguments, const std::string& no_colour = {});

// How a command is started, where that matters.
struct Surroundings {
  enum class Output { kCollected, kFile, kClosedPipe };

  Output output = Output::kCollected;  // kClosedPipe: a pipe without a reader
  std::string file = {};               // where standard output goes with kFile
  bool input_on_terminal = false;
  bool error_on_terminal = false;
  std::size_t memory_bytes = 0;  // the most it may take; 0: no limit
  std::size_t file_bytes = 0;    // the longest file that it may write; 0: no limit
  bool unprivileged = false;     // of root's rights it keeps none
};

// Runs `beespace <arguments>` to its end; `input` is its standard input.
Finished run(const Arguments& arguments, std::string_view input = {},
             const Surroundings& surroundings = {});

// A command that is still running. Its standard input stays open until close_input().
class Running {
 public:
  explicit Running(const Arguments& arguments, const Surroundings& surroundings = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void send(std::string_view input) const;
  void close_input();
  void signal(int number) const;
  // The next line of standard output, without its end; what there is where it takes ten seconds.
  [[nodiscard]] std::string read_line() const;
  // The same of standard error.
  [[nodiscard]] std::string read_error_line() const;
  // Waits for its end; at most a minute, then it is killed.
  Finished finish();

 private:
  pid_t process_ = -1;
  int input_ = -1;
  int output_ = -1;
  int error_ = -1;
};

}  // namespace beespace::cli_test
