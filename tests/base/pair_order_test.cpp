#include "base/pair_order.hpp"

#include "tests/support/own_resources.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace beespace::core {
namespace {

using Pairs = std::vector<Pair>;

// As one worker would have found them.
void write_down(const Pairs& pairs, FoundPairs& found) {
  std::size_t next = 0;
  while (next < pairs.size()) {
    FoundPairs::Chunk& chunk = found.open_chunk();
    const std::size_t wanted = std::min<std::size_t>(chunk.capacity, pairs.size() - next);
    for (; chunk.size < wanted; ++chunk.size) {
      chunk.first[chunk.size] = pairs[next + chunk.size].first;
      chunk.second[chunk.size] = pairs[next + chunk.size].second;
    }
    next += wanted;
  }
  if (next % 2 == 0) found.open_chunk();  // one that was opened in vain
}

Pairs sorted(const Pairs& pairs, Direction direction) {
  Pairs all = pairs;
  for (const Pair& pair : pairs) {
    if (direction == Direction::kBothWays) all.push_back({pair.second, pair.first});
  }
  for (Pair& pair : all) {
    if (direction == Direction::kAscending && pair.first > pair.second) {
      std::swap(pair.first, pair.second);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

// In so many parts, some of which may be empty, in all directions.
void expect_order(const Pairs& pairs, std::uint64_t first_ids) {
  for (const unsigned workers : {1U, 2U, 5U}) {
    test::OwnResources own(workers);
    Vector<FoundPairs> found(&own.memory);
    ASSERT_EQ(own.crew.size(), workers);
    for (unsigned part = 0; part < workers; ++part) {
      const auto [begin, end] = own.crew.share(pairs.size(), part);
      found.emplace_back(own.memory);
      write_down({pairs.begin() + static_cast<std::ptrdiff_t>(begin),
                  pairs.begin() + static_cast<std::ptrdiff_t>(end)},
                 found.back());
    }
    for (const Direction direction :
         {Direction::kAsFound, Direction::kAscending, Direction::kBothWays}) {
      const Pairs expected = sorted(pairs, direction);
      Pairs ordered(expected.size() + 1, Pair{7, 77});
      order_pairs(found, direction, first_ids, own.with, ordered.data());
      ASSERT_EQ(ordered.back(), (Pair{7, 77})) << "written beyond the end";
      ordered.pop_back();
      ASSERT_EQ(ordered, expected) << workers << " parts, direction " << int(direction);
    }
  }
}

class Drawing {
 public:
  explicit Drawing(std::uint32_t seed) : random_(seed) {}

  PointId from(std::uint64_t low, std::uint64_t end) {
    return static_cast<PointId>(low + random_() % (end - low));
  }
  // Different ids each, from [low, end).
  Pairs pairs(std::size_t count, std::uint64_t low, std::uint64_t end) {
    Pairs drawn;
    while (drawn.size() < count) {
      const Pair pair{from(low, end), from(low, end)};
      if (pair.first != pair.second) drawn.push_back(pair);
    }
    return drawn;
  }

 private:
  std::mt19937_64 random_;
};

TEST(PairOrder, IsThatOfAnySortWhateverTheNumbers) {
  for (const std::size_t count : {0U, 1U, 2U, 24U, 25U, 300U, 5000U, 70'000U}) {
    for (const std::uint64_t ids : {2U, 3U, 64U, 1000U, 100'000U}) {
      SCOPED_TRACE(std::to_string(count) + " pairs of " + std::to_string(ids) + " ids");
      expect_order(Drawing(static_cast<std::uint32_t>(count + ids)).pairs(count, 0, ids), ids);
    }
  }
}

TEST(PairOrder, OfOneIdWithVeryManyAndOfTheRestWithFew) {
  Drawing draw(3);
  Pairs pairs = draw.pairs(4000, 0, 50'000);
  for (int k = 0; k < 60'000; ++k) pairs.push_back({12'345, draw.from(20'000, 50'000)});
  std::shuffle(pairs.begin(), pairs.end(), std::mt19937(1));
  expect_order(pairs, 50'000);
}

// Ids up to the highest that there are; the sums and shifts must not run over.
TEST(PairOrder, OfTheHighestIds) {
  for (const std::size_t count : {1U, 30U, 200U, 3000U}) {
    SCOPED_TRACE(count);
    Drawing draw(static_cast<std::uint32_t>(count));
    expect_order(draw.pairs(count, kMaxPoints - 5000, kMaxPoints), kMaxPoints);
    expect_order(draw.pairs(count, 0, kMaxPoints), kMaxPoints);
  }
}

TEST(FoundPairs, KnowHowManyTheyAre) {
  Memory memory;
  FoundPairs found(memory);
  EXPECT_EQ(found.size(), 0U);
  write_down(Drawing(1).pairs(kFirstChunk + 9, 0, 100), found);
  EXPECT_EQ(found.size(), kFirstChunk + 9);
  EXPECT_EQ(found.chunks().size(), 2U);
}

// Enough for chunks of the later size.
TEST(FoundPairs, AreOrderedFromChunksOfAnySize) {
  const std::size_t many = kFirstChunks * kFirstChunk + kLaterChunk + 999;
  const Pairs pairs = Drawing(2).pairs(many, 0, 1U << 20);
  Memory memory;
  FoundPairs found(memory);
  write_down(pairs, found);
  EXPECT_EQ(found.chunks().size(), kFirstChunks + 2);
  EXPECT_EQ(found.size(), many);
  expect_order(pairs, 1U << 20);
}

}  // namespace
}  // namespace beespace::core
