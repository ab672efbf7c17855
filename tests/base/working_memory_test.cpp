// Memory that is kept, in a program that counts requests to the system.
#include "base/memory.hpp"

#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "tests/support/allocation_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace beespace::core {
namespace {

using test::allocations;
using test::blocks_held;

// Requests blocks of these sizes one after another, writes all of each, and gives them back.
void use(Memory& memory, const std::vector<std::size_t>& sizes) {
  std::vector<void*> blocks;
  for (const std::size_t bytes : sizes) {
    blocks.push_back(memory.allocate(bytes));
    std::memset(blocks.back(), 0xAB, bytes);
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) memory.deallocate(blocks[i], sizes[i]);
}

std::uint64_t new_blocks_of(Memory& memory, const std::vector<std::size_t>& sizes) {
  std::vector<void*> blocks;
  blocks.reserve(sizes.size());
  const std::uint64_t before = allocations();
  for (const std::size_t bytes : sizes) blocks.push_back(memory.allocate(bytes));
  const std::uint64_t after = allocations();
  for (std::size_t i = 0; i < sizes.size(); ++i) memory.deallocate(blocks[i], sizes[i]);
  return after - before;
}

constexpr std::size_t kHugePage = std::size_t{1} << 21;

const std::vector<std::size_t> kOddSizes = {0,    1,       63,        64,        65,       1000,
                                            4097, 123'457, 2'097'151, 2'097'152, 5'000'000};

TEST(Memory, NewBlocksComeFromTheSystemOnce) {
  Memory memory;
  EXPECT_GE(new_blocks_of(memory, kOddSizes), kOddSizes.size());
  EXPECT_EQ(new_blocks_of(memory, kOddSizes), 0U);
  std::vector<std::size_t> other_way_round(kOddSizes.rbegin(), kOddSizes.rend());
  EXPECT_EQ(new_blocks_of(memory, other_way_round), 0U);
}

// A frame of slightly more points than the one before.
TEST(Memory, KeptBlocksServeSizesThatAreALittleLarger) {
  Memory memory;
  use(memory, {100'000, 3'000'001});
  std::uint64_t fresh = 0;
  for (std::size_t more = 0; more < 500; more += 100) {
    fresh += new_blocks_of(memory, {100'000 + more, 3'000'001 + 10 * more});
  }
  EXPECT_LE(fresh, 2U);
}

// A swarm that grows from frame to frame leaves a few blocks behind, not two a frame.
TEST(Memory, KeepsFewBlocksAsSizesGrow) {
  Memory memory;
  const std::uint64_t held = blocks_held();
  std::size_t frames = 0;
  for (std::size_t bytes = 1000; bytes < 100'000'000; bytes += bytes / 50) {
    memory.start_call();
    (void)new_blocks_of(memory, {bytes, bytes});
    ++frames;
  }
  EXPECT_GT(frames, 500U);
  EXPECT_LE(blocks_held() - held, 60U);
}

// Each worker's requests come in the worker's own order, whatever others request meanwhile.
TEST(Memory, OfAWorkerIsItsOwn) {
  Memory memory;
  EXPECT_EQ(&memory.of(0), &memory);
  EXPECT_EQ(&memory.of(2), &memory.of(2));
  EXPECT_NE(&memory.of(1), &memory.of(2));
  use(memory.of(1), kOddSizes);
  EXPECT_EQ(new_blocks_of(memory.of(1), kOddSizes), 0U);
  EXPECT_EQ(new_blocks_of(memory.of(2), kOddSizes), kOddSizes.size());
  const std::uint64_t held = blocks_held();
  memory.release();
  EXPECT_EQ(held - blocks_held(), 2 * kOddSizes.size());
}

TEST(Memory, BlocksOfTheSameTimeDoNotOverlapAndAreAligned) {
  Memory memory;
  for (int round = 0; round < 3; ++round) {
    std::vector<Buffer<unsigned char>> buffers;
    for (const std::size_t bytes : kOddSizes) {
      Buffer<unsigned char>& buffer = buffers.emplace_back(memory, bytes);
      const auto address = reinterpret_cast<std::uintptr_t>(buffer.data());
      EXPECT_EQ(address % 64, 0U) << bytes;
      EXPECT_EQ(bytes < kHugePage ? 0U : address % kHugePage, 0U) << bytes;
      std::fill_n(buffer.data(), bytes, static_cast<unsigned char>(buffers.size()));
    }
    for (std::size_t k = 0; k < kOddSizes.size(); ++k) {
      EXPECT_EQ(std::count(buffers[k].data(), buffers[k].data() + kOddSizes[k],
                           static_cast<unsigned char>(k + 1)),
                static_cast<std::ptrdiff_t>(kOddSizes[k]));
    }
  }
}

TEST(Memory, MoreThanThereIsIsAnExceptionAndTheRestLivesOn) {
  Memory memory;
  use(memory, {1000});
  for (const std::size_t bytes : {SIZE_MAX, SIZE_MAX - 63, SIZE_MAX / 2 + 1}) {
    EXPECT_THROW((void)memory.allocate(bytes), std::bad_alloc) << bytes;
  }
  use(memory, kOddSizes);
  EXPECT_EQ(new_blocks_of(memory, kOddSizes), 0U);
}

TEST(Memory, GivesBackAllThatIsUnused) {
  const std::uint64_t before = blocks_held();
  {
    Memory memory;
    Buffer<int> in_use(memory, 1000);
    std::fill_n(in_use.data(), 1000, 7);
    use(memory, kOddSizes);
    const std::uint64_t held = blocks_held();
    memory.release();
    EXPECT_EQ(held - blocks_held(), kOddSizes.size());
    EXPECT_EQ(std::count(in_use.data(), in_use.data() + 1000, 7), 1000);
    EXPECT_EQ(new_blocks_of(memory, kOddSizes), kOddSizes.size());
  }
  EXPECT_EQ(blocks_held(), before);
}

TEST(Buffer, MovesAndIsReusedWithoutNewMemory) {
  Memory memory;
  Buffer<std::uint64_t> first(memory, 1000);
  void* const place = first.data();
  const std::uint64_t before = allocations();
  Buffer<std::uint64_t> second(std::move(first));
  EXPECT_EQ(second.data(), place);
  Buffer<std::uint32_t> third = std::move(second).reused_as<std::uint32_t>();
  EXPECT_EQ(static_cast<void*>(third.data()), place);
  EXPECT_EQ(allocations(), before);
}

TEST(Buffer, OfItsOwnMemoryGivesItBack) {
  const std::uint64_t before = blocks_held();
  {
    Buffer<double> own(300'000);
    own[299'999] = 1.0;
    Buffer<double> moved = std::move(own);
    EXPECT_EQ(moved[299'999], 1.0);
    EXPECT_EQ(blocks_held(), before + 1);
  }
  EXPECT_EQ(blocks_held(), before);
}

}  // namespace
}  // namespace beespace::core
