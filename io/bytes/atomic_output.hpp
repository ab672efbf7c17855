// Output that is there whole or not at all.
//
// A file is written under a temporary name beside the final one and renamed on commit(); without
// commit() it vanishes and what was there before stays. An existing file keeps its permissions; of
// a symbolic link the file it leads to is replaced. "-" (standard output), pipes and devices are
// written to directly. Buffered (1 MiB); the first error is kept, later writes do nothing, and
// commit() reports it. One object, one thread. A program that writes to pipes should ignore
// SIGPIPE, or it ends before pipe_closed() can say why. What is written may go out
// gzip-compressed.
#pragma once

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

class GzipStream;

enum class Packing : std::uint8_t { kPlain, kGzip };

class AtomicOutput {
 public:
  // Errors: kWriteFailed.
  static Result<AtomicOutput> open(const std::string& path, Packing packing = Packing::kPlain);
  AtomicOutput(AtomicOutput&& other) noexcept;
  AtomicOutput& operator=(AtomicOutput&& other) noexcept;
  AtomicOutput(const AtomicOutput&) = delete;
  AtomicOutput& operator=(const AtomicOutput&) = delete;
  ~AtomicOutput();

  void write(std::string_view text);
  // Flushes, gives the file its name, and says whether every byte arrived. Errors: kWriteFailed.
  Status commit();

  // Whether writing has failed already, so that more is of no use.
  [[nodiscard]] bool failed() const { return error_number_ != 0; }
  // Whether it failed because the pipe is not read any more: other tools then end quietly.
  [[nodiscard]] bool pipe_closed() const;

 private:
  AtomicOutput();
  static Result<AtomicOutput> open_plain(const std::string& path);
  bool create_temporary();
  void write_plain(std::string_view text);
  void send(const char* data, std::size_t size);
  void flush();
  void discard();
  [[nodiscard]] Error error() const;

  static constexpr std::size_t kNotRegistered = 16;

  std::string path_;            // as the caller says it, for messages
  std::string final_path_;      // links followed; empty when written directly
  std::string temporary_path_;  // empty when written directly, or done
  int descriptor_ = -1;
  int error_number_ = 0;
  std::size_t registered_ = kNotRegistered;  // where the signal handler finds temporary_path_
  std::vector<char> buffer_;
  std::unique_ptr<GzipStream> gzip_;  // null: plain
};

// Removes the temporary files of outputs that are open now; async-signal-safe. At most 16 files
// are open at a time.
void discard_open_outputs_in_signal_handler() noexcept;

}  // namespace beespace::io
