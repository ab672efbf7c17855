// A temporary file of blocks, each of which is compared with its checksum when it is read.
#pragma once

#include "out_of_core/temporary_file.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace beespace::out_of_core {

class BlockFile {
 public:
  // Where bytes are, and what they were.
  struct Block {
    std::uint64_t offset = 0;
    std::uint64_t checksum = 0;
    std::uint64_t bytes = 0;
  };

  // As TemporaryFile::make.
  static Result<BlockFile> make(const std::string& folder, std::uint64_t needed_bytes);

  // Any number of threads at a time. Errors: kWriteFailed.
  Result<Block> append(std::span<const std::byte> bytes);
  // Into as many bytes as the block has. Any number of threads. Errors: kReadFailed, kCorrupt.
  [[nodiscard]] Status read(const Block& block, std::span<std::byte> bytes) const;

 private:
  explicit BlockFile(TemporaryFile file) : file_(std::move(file)) {}

  TemporaryFile file_;
};

}  // namespace beespace::out_of_core
