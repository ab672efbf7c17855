#include "base/memory.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace beespace::core {

namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;
constexpr std::size_t kCacheLine = 64;
constexpr std::size_t kBlocks = 64;  // as many as most searches use

std::align_val_t alignment_of(std::size_t bytes) {
  return std::align_val_t{bytes >= kHugePage ? kHugePage : kCacheLine};
}

// Sizes are rounded up, large ones by an eighth at most, so that the blocks of one frame fit the
// next, which is never quite the same.
std::size_t rounded_up(std::size_t bytes) {
  if (bytes > SIZE_MAX / 2) throw std::bad_alloc();
  constexpr std::size_t kLarge = std::size_t{1} << 18;
  if (bytes < kLarge) return std::bit_ceil(std::max(bytes, kCacheLine));
  const std::size_t step = std::max(kCacheLine, std::bit_floor(bytes) / 8);
  return (bytes + step - 1) / step * step;
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

void trim_freed_memory([[maybe_unused]] std::size_t bytes) {
#if defined(__GLIBC__)
  // It looks through all that is free.
  constexpr std::size_t kWorthWhile = std::size_t{1} << 22;
  if (bytes >= kWorthWhile) malloc_trim(0);
#endif
}

Memory::Memory() {
  kept_.reserve(kBlocks);
  lent_.reserve(kBlocks);
}

Memory::~Memory() {
  free_all_kept();
}

Memory& Memory::of(unsigned worker) {
  if (worker == 0) return *this;
  const std::lock_guard lock(mutex_);
  while (of_workers_.size() < worker) {
    of_workers_.push_back(std::make_unique<Memory>());
    of_workers_.back()->calls_ = calls_;
    of_workers_.back()->most_ = most_;
  }
  return *of_workers_[worker - 1];
}

void Memory::release() {
  trim_freed_memory(free_all_kept());
}

std::size_t Memory::free_all_kept() {
  const std::lock_guard lock(mutex_);
  std::size_t bytes = free_kept();
  for (const auto& memory : of_workers_) bytes += memory->free_all_kept();
  return bytes;
}

void Memory::bound(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  most_ = bytes;
  for (const auto& memory : of_workers_) memory->bound(bytes);
}

bool Memory::is_full(std::size_t bytes) const {
  if (most_ == SIZE_MAX) return false;
  std::size_t all = bytes;
  for (const Block& block : kept_) all += block.bytes;
  for (const Block& block : lent_) all += block.bytes;
  return all > most_;
}

// A block of exactly this size: so a frame gets the blocks of a similar frame before, whatever came
// between.
std::size_t Memory::find_kept(std::size_t bytes) const {
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [bytes](const Block& kept) { return kept.bytes == bytes; });
  return static_cast<std::size_t>(found - kept_.begin());
}

std::size_t Memory::free_kept() {
  std::size_t bytes = 0;
  for (const Block& block : kept_) {
    free_block(block.data, block.bytes);
    bytes += block.bytes;
  }
  kept_.clear();
  return bytes;
}

void Memory::start_call() {
  constexpr std::uint64_t kRemembered = 32;
  const std::lock_guard lock(mutex_);
  ++calls_;
  for (const auto& memory : of_workers_) memory->start_call();
  std::erase_if(kept_, [this](const Block& block) {
    if (calls_ - block.last_call <= kRemembered) return false;
    free_block(block.data, block.bytes);
    return true;
  });
}

void* Memory::do_allocate(std::size_t bytes, std::size_t /*alignment: a cache line serves all*/) {
  const std::size_t whole = rounded_up(bytes);
  const std::lock_guard lock(mutex_);
  const std::size_t found = find_kept(whole);
  if (found < kept_.size()) {
    lent_.push_back(kept_[found]);
    kept_[found] = kept_.back();
    kept_.pop_back();
  } else {
    if (is_full(whole)) {
      // Else the allocator keeps them for blocks of the same size, and the bound is none.
      trim_freed_memory(free_kept());
    } else if (calls_ <= 1) {
      free_kept();
    }
    // Room for all blocks in either list first: giving back must not fail.
    const std::size_t blocks = kept_.size() + lent_.size() + 1;
    if (kept_.capacity() < blocks) kept_.reserve(2 * blocks);
    if (lent_.capacity() < blocks) lent_.reserve(2 * blocks);
    lent_.push_back({allocate_block(whole), whole, calls_});
  }
  lent_.back().last_call = calls_;
  return lent_.back().data;
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
