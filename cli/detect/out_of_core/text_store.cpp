#include "cli/detect/out_of_core/text_store.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace beespace::cli {

void TextStore::add(std::string_view text) {
  texts_ += text;
  ends_.push_back(static_cast<std::uint32_t>(texts_.size()));
  if (ends_.size() == kPointsInBlock) write_block();
}

// As many ends as texts, then the texts.
void TextStore::write_block() {
  ends_.resize(kPointsInBlock, static_cast<std::uint32_t>(texts_.size()));
  if (!file_ && status_) {
    auto made = io::ScratchFile::make(folder_);
    if (made) {
      file_.emplace(*std::move(made));
    } else {
      status_ = std::move(made).error();
    }
  }
  if (status_) {
    std::string bytes(reinterpret_cast<const char*>(ends_.data()),
                      ends_.size() * sizeof(std::uint32_t));
    bytes += texts_;
    const auto block = file_->append(bytes);
    if (block) {
      blocks_.push_back(*block);
    } else {
      status_ = block.error();
    }
  }
  ends_.clear();
  texts_.clear();
}

void TextStore::finish(std::size_t memory_bytes) {
  if (!ends_.empty()) write_block();
  std::uint32_t largest = 1;
  for (const auto& block : blocks_) largest = std::max(largest, block.size);
  kept_.resize(std::clamp<std::size_t>(memory_bytes / largest, 2, blocks_.size() + 2));
}

const TextStore::Kept* TextStore::block(std::size_t number) {
  Kept& kept = kept_[number % kept_.size()];
  if (kept.number == number) return &kept;
  if (!status_) return nullptr;
  kept.number = std::numeric_limits<std::size_t>::max();
  kept.bytes.resize(blocks_[number].size);
  if (auto status = file_->read(blocks_[number], kept.bytes); !status) {
    status_ = std::move(status);
    return nullptr;
  }
  kept.number = number;
  return &kept;
}

std::string_view TextStore::text(LargeId point) {
  const Kept* const kept = block(point / kPointsInBlock);
  if (kept == nullptr) return {};
  const std::size_t index = point % kPointsInBlock;
  std::array<std::uint32_t, 2> ends{};
  const std::size_t first = index == 0 ? 0 : index - 1;
  std::memcpy(ends.data(), kept->bytes.data() + first * sizeof ends[0], sizeof ends);
  const std::uint32_t begin = index == 0 ? 0 : ends[0];
  const std::uint32_t end = index == 0 ? ends[0] : ends[1];
  const char* const texts = kept->bytes.data() + kPointsInBlock * sizeof ends[0];
  return {texts + begin, end - begin};
}

}  // namespace beespace::cli
