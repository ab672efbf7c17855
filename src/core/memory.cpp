#include "core/memory.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace beespace::core {

namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;
constexpr std::size_t kCacheLine = 64;
constexpr std::size_t kBlocks = 64;  // more than any search uses; room for them is made at once

std::align_val_t alignment_of(std::size_t bytes) {
  return std::align_val_t{bytes >= kHugePage ? kHugePage : kCacheLine};
}

// Sizes are rounded up by at most an eighth, so that the blocks of a frame fit the next one, which
// is never quite the same.
std::size_t rounded_up(std::size_t bytes) {
  if (bytes > SIZE_MAX / 2) throw std::bad_alloc();
  const std::size_t step = std::max(kCacheLine, std::bit_floor(bytes) / 8);
  return std::max(kCacheLine, (bytes + step - 1) / step * step);
}

}  // namespace

void advise_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  const auto begin = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t first = (begin + kHugePage - 1) / kHugePage * kHugePage;
  if (first + kHugePage > begin + bytes) return;
  madvise(static_cast<std::byte*>(data) + (first - begin), begin + bytes - first, MADV_HUGEPAGE);
#endif
}

void* allocate_block(std::size_t bytes) {
  void* const data = ::operator new(bytes, alignment_of(bytes));
  advise_huge_pages(data, bytes);
  return data;
}

void free_block(void* data, std::size_t bytes) {
  ::operator delete(data, alignment_of(bytes));
}

Memory::Memory() {
  kept_.reserve(kBlocks);
  lent_.reserve(kBlocks);
}

Memory::~Memory() {
  release();
}

void Memory::release() {
  const std::lock_guard lock(mutex_);
  for (const Block& block : kept_) free_block(block.data, block.bytes);
  kept_.clear();
}

void* Memory::do_allocate(std::size_t bytes, std::size_t /*alignment: a cache line serves all*/) {
  const std::size_t whole = rounded_up(bytes);
  const std::lock_guard lock(mutex_);
  // The smallest kept block that is large enough, or the largest of those that are not.
  auto best = kept_.end();
  for (auto block = kept_.begin(); block != kept_.end(); ++block) {
    const bool fits = block->bytes >= whole;
    if (best == kept_.end()) {
      best = block;
    } else if (fits != (best->bytes >= whole)) {
      if (fits) best = block;
    } else if (fits ? block->bytes < best->bytes : block->bytes > best->bytes) {
      best = block;
    }
  }
  lent_.reserve(lent_.size() + 1);
  Block block{nullptr, whole};
  if (best != kept_.end()) {
    block = *best;
    *best = kept_.back();
    kept_.pop_back();
  }
  if (block.bytes < whole || block.data == nullptr) {
    // Replaced, not added to: frames that grow slowly must not leave a trail of blocks.
    free_block(block.data, block.bytes);
    block = {allocate_block(whole), whole};
  }
  lent_.push_back(block);
  kept_.reserve(kept_.size() + lent_.size());
  return block.data;
}

void Memory::do_deallocate(void* data, std::size_t, std::size_t) {
  const std::lock_guard lock(mutex_);
  const auto block = std::find_if(lent_.rbegin(), lent_.rend(),
                                  [data](const Block& lent) { return lent.data == data; });
  kept_.push_back(*block);
  *block = lent_.back();
  lent_.pop_back();
}

}  // namespace beespace::core
