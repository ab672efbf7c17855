// `beespace watch` as a process of its own, at the two ends of its pipes.
#pragma once

#include <sys/types.h>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::closed_loop {

class WatchProcess {
 public:
  // `command` is the built program; `arguments` follow its name.
  WatchProcess(const std::string& command, const std::vector<std::string>& arguments);
  ~WatchProcess();
  WatchProcess(const WatchProcess&) = delete;
  WatchProcess& operator=(const WatchProcess&) = delete;

  // Writes all of it, and reads meanwhile, so that neither end waits for the other for ever.
  void send(std::string_view text);

  // The next line of standard output, without its end; false where none comes in time, or any more.
  bool next_line(std::string& line, int patience_ms);

  // Closes its input and waits for its end. Returns its exit status, or -1 if a signal ended it,
  // which is sent after a minute. The rest of its output can be read afterwards.
  int finish();

  [[nodiscard]] const std::string& errors() const { return errors_; }

 private:
  void read_what_there_is(int patience_ms);

  pid_t process_ = -1;
  int input_ = -1;
  int output_ = -1;
  int error_ = -1;
  std::string said_;
  std::size_t taken_ = 0;
  std::string errors_;
};

}  // namespace beespace::closed_loop
