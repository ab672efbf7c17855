// An input that is open: a file, or standard input.
#pragma once

#include "io/bytes/byte_source.hpp"
#include "io/bytes/descriptor.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace beespace::io {

class InputFile {
 public:
  // What tells that a regular file is another one, or was written to.
  struct State {
    std::uint64_t device = 0;
    std::uint64_t number = 0;
    std::uint64_t size = 0;
    std::int64_t changed_s = 0;
    std::int64_t changed_ns = 0;

    friend bool operator==(const State&, const State&) = default;
  };

  // `path` is a file name, or "-" for standard input. Errors: kCannotOpen.
  static Result<InputFile> open(const std::string& path);

  // Reads at most so many bytes; how many, 0 at the end. Errors: kReadFailed, kCannotOpen.
  Result<std::size_t> read(char* into, std::size_t most) const;

  // All of a regular file that is read from its start; nothing of pipes, devices and empty files.
  [[nodiscard]] std::optional<Bytes> map() const;

  // How many bytes a regular file had when it was opened; 0 where that is not known.
  [[nodiscard]] std::uint64_t size() const { return state_ ? state_->size : 0; }

  // When it was opened; nothing of what is no regular file.
  [[nodiscard]] const std::optional<State>& state() const { return state_; }
  // Errors: kReadFailed where a regular file is not in that state any more.
  [[nodiscard]] Status check_unchanged() const;

 private:
  InputFile(std::string path, Descriptor owned, int number)
      : path_(std::move(path)), owned_(std::move(owned)), number_(number) {}

  std::string path_;
  Descriptor owned_;  // none of standard input
  int number_;
  std::optional<State> state_;
  bool from_start_ = false;
};

// kReadFailed: the file is not what it was.
Error written_meanwhile(const std::string& path);

}  // namespace beespace::io
