#include "out_of_core/block_file.hpp"

#include "out_of_core/checksum.hpp"

#include <array>

namespace beespace::out_of_core {

namespace {

std::uint64_t checksum_of(std::span<const std::byte> bytes) {
  Checksum checksum;
  checksum.add(bytes);
  return checksum.value();
}

}  // namespace

Result<BlockFile> BlockFile::make(const std::string& folder, std::uint64_t needed_bytes) {
  auto file = TemporaryFile::make(folder, needed_bytes);
  if (!file) return std::move(file).error();
  return BlockFile(*std::move(file));
}

Result<BlockFile::Block> BlockFile::append(std::span<const std::byte> bytes) {
  const auto offset = file_.append(bytes);
  if (!offset) return offset.error();
  return Block{*offset, checksum_of(bytes), bytes.size()};
}

Status BlockFile::read(const Block& block, std::span<std::byte> bytes) const {
  std::array<iovec, 1> parts = {{{bytes.data(), bytes.size()}}};
  if (auto status = file_.read(block.offset, parts); !status) return status;
  if (checksum_of(bytes) != block.checksum) {
    return Error{ErrorCode::kCorrupt, "a temporary file does not hold what was written to it", {}};
  }
  return std::monostate{};
}

}  // namespace beespace::out_of_core
