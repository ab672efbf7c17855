// The bytes of an input one after the other, in memory that does not grow with it: unpacked, where
// they are compressed.
#pragma once

#include "io/bytes/gzip.hpp"
#include "io/bytes/input_file.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

class ByteStream {
 public:
  // `path` as for open_bytes(). Errors: kCannotOpen, kReadFailed.
  static Result<ByteStream> open(const std::string& path);

  // Fills the free room of `into`; room is left at the end only. Errors: kReadFailed, also where
  // the file was written to meanwhile; kTruncated and kCorrupt of compressed bytes.
  Status read(GrowingBytes& into);

  [[nodiscard]] bool is_compressed() const { return unpacking_.has_value(); }
  // "gzip" or "zstd", where it is.
  [[nodiscard]] std::string_view packed_by() const { return packed_by_; }
  [[nodiscard]] const InputFile& file() const { return file_; }
  // How many bytes of the file itself were read.
  [[nodiscard]] std::uint64_t taken() const { return taken_; }

 private:
  explicit ByteStream(InputFile file) : file_(std::move(file)) {}

  // More of the file behind `waiting_`.
  Status fill();

  InputFile file_;
  std::optional<Unpacking> unpacking_;
  std::string_view packed_by_ = {};
  std::vector<char> buffer_;       // of compressed bytes; at first of any
  std::string_view waiting_ = {};  // in it
  bool ended_ = false;             // the file
  std::uint64_t taken_ = 0;
};

}  // namespace beespace::io
