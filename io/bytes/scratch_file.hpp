// A temporary file without a name, which is gone when the program ends, however it ends. Blocks are
// written behind each other; what is read back is compared with a checksum.
#pragma once

#include "io/bytes/descriptor.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::io {

class ScratchFile {
 public:
  // Where a block is, and what tells whether it is what it was.
  struct Block {
    std::uint64_t offset = 0;
    std::uint32_t size = 0;
    std::uint32_t checksum = 0;
  };

  // Errors: kWriteFailed.
  static Result<ScratchFile> make(const std::string& folder);

  // Less than 4 GiB. Errors: kWriteFailed.
  Result<Block> append(std::string_view bytes);
  // `into` has the size of the block. Errors: kReadFailed, kCorrupt.
  [[nodiscard]] Status read(const Block& block, std::span<char> into) const;

 private:
  ScratchFile(Descriptor file, std::string folder)
      : file_(std::move(file)), folder_(std::move(folder)) {}
  [[nodiscard]] Error failed(ErrorCode code, const char* doing, int error_number) const;

  Descriptor file_;
  std::string folder_;
  std::uint64_t size_ = 0;
};

// The bytes that are free in a folder. Errors: kWriteFailed where there is no such folder.
Result<std::uint64_t> free_bytes_in(const std::string& folder);

}  // namespace beespace::io
