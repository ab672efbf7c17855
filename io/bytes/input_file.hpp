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
  // `path` is a file name, or "-" for standard input. Errors: kCannotOpen.
  static Result<InputFile> open(const std::string& path);

  // Reads at most so many bytes; how many, 0 at the end. Errors: kReadFailed, kCannotOpen.
  Result<std::size_t> read(char* into, std::size_t most) const;

  // All of a regular file that is read from its start; nothing of pipes, devices and empty files.
  [[nodiscard]] std::optional<Bytes> map() const;

  // How many bytes a regular file had when it was opened; 0 where that is not known.
  [[nodiscard]] std::uint64_t size() const { return state_ ? state_->size : 0; }

  // Errors: kReadFailed where a regular file was written to since it was opened.
  [[nodiscard]] Status check_unchanged() const;

 private:
  // What tells that a file was written to.
  struct State {
    std::uint64_t size = 0;
    std::int64_t changed_s = 0;
    std::int64_t changed_ns = 0;

    friend bool operator==(const State&, const State&) = default;
  };

  InputFile(std::string path, Descriptor owned, int number)
      : path_(std::move(path)), owned_(std::move(owned)), number_(number) {}

  std::string path_;
  Descriptor owned_;  // none of standard input
  int number_;
  std::optional<State> state_;  // of a regular file
  bool from_start_ = false;
};

}  // namespace beespace::io
