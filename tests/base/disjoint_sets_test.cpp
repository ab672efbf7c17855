#include "base/disjoint_sets.hpp"

#include <beespace/crew.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <random>
#include <thread>
#include <utility>
#include <vector>

namespace beespace::core {
namespace {

using Joins = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// The lowest element of each element's set, by passing the lower one on until nothing changes.
std::vector<std::uint32_t> lowest_by_passing_on(std::uint32_t size, const Joins& joins) {
  std::vector<std::uint32_t> lowest(size);
  std::iota(lowest.begin(), lowest.end(), 0U);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : joins) {
      const std::uint32_t lower = std::min(lowest[a], lowest[b]);
      changed = changed || lowest[a] != lower || lowest[b] != lower;
      lowest[a] = lowest[b] = lower;
    }
  }
  return lowest;
}

std::vector<std::uint32_t> roots(DisjointSets& sets, std::uint32_t size) {
  std::vector<std::uint32_t> all(size);
  for (std::uint32_t thing = 0; thing < size; ++thing) all[thing] = sets.root(thing);
  return all;
}

Joins random_joins(std::uint32_t size, std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  Joins joins(count);
  for (auto& [a, b] : joins) {
    a = static_cast<std::uint32_t>(random() % size);
    b = static_cast<std::uint32_t>(random() % size);
  }
  return joins;
}

TEST(DisjointSets, AreAsManyAsThingsAtFirst) {
  Memory memory;
  DisjointSets sets(memory, 5);
  EXPECT_EQ(roots(sets, 5), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(DisjointSets, HaveTheirLowestThingAsRoot) {
  Memory memory;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const std::uint32_t size = 1 + seed;
    const Joins joins = random_joins(size, seed % 7 * size / 5, seed);
    DisjointSets sets(memory, size);
    for (const auto& [a, b] : joins) sets.join(a, b);
    ASSERT_EQ(roots(sets, size), lowest_by_passing_on(size, joins)) << seed;
  }
}

// Chains, a star and pairs at random, joined by all workers at once while they also look up roots.
TEST(DisjointSets, AreTheSameWhenManyJoinAtOnce) {
  constexpr std::uint32_t kSize = 3000;
  constexpr std::uint32_t kEnd = kSize / 3;
  Memory memory;
  ThreadCrew crew(4);
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    Joins joins = random_joins(kSize, kSize / 3, seed);
    for (std::uint32_t i = 0; i + 3 < kEnd; ++i) joins.emplace_back(i, i + 3);
    for (std::uint32_t i = kEnd; i < 2 * kEnd; i += 2) joins.emplace_back(i, 2 * kEnd - 1);
    std::shuffle(joins.begin(), joins.end(), std::mt19937(seed));
    DisjointSets sets(memory, kSize);
    std::vector<std::size_t> astray(crew.size(), 0);
    crew.run([&](unsigned worker) {
      Joins mine = joins;  // all of them, in an order of its own
      std::shuffle(mine.begin(), mine.end(), std::mt19937(worker));
      for (const auto& [a, b] : mine) {
        sets.join(a, b);
        if (sets.root(a) > a || sets.root(b) > b) ++astray[worker];
      }
    });
    EXPECT_EQ(std::accumulate(astray.begin(), astray.end(), std::size_t{0}), 0U);
    ASSERT_EQ(roots(sets, kSize), lowest_by_passing_on(kSize, joins)) << seed;
  }
}

// Two threads hang the same things on different others, one from the front and one from the back:
// they meet in the middle of every stretch, and neither join may be lost.
TEST(DisjointSets, LoseNoJoinWhereTwoThreadsMeet) {
  constexpr std::uint32_t kStretches = 2000;
  constexpr std::uint32_t kStretch = 64;
  Memory memory;
  DisjointSets sets(memory, 3 * kStretches * kStretch);
  std::atomic<std::uint32_t> arrived = 0;
  const auto join_from = [&](std::uint32_t side) {
    for (std::uint32_t stretch = 0; stretch < kStretches; ++stretch) {
      ++arrived;
      while (arrived < 2 * (stretch + 1)) std::this_thread::yield();
      for (std::uint32_t step = 0; step < kStretch; ++step) {
        const std::uint32_t at = side == 0 ? step : kStretch - 1 - step;
        const std::uint32_t first = 3 * (stretch * kStretch + at);
        sets.join(first + side, first + 2);
      }
    }
  };
  std::thread other(join_from, 1);
  join_from(0);
  other.join();
  for (std::uint32_t thing = 0; thing < 3 * kStretches * kStretch; ++thing) {
    ASSERT_EQ(sets.root(thing), thing / 3 * 3);
  }
}

}  // namespace
}  // namespace beespace::core
