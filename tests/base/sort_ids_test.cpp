#include "base/sort_ids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace beespace::core {
namespace {

// Spread evenly, crowded at one end, all the same, in two far clumps, and already in order.
std::vector<std::vector<PointId>> some_ids(std::size_t count, std::mt19937& random) {
  std::vector<PointId> even(count);
  std::vector<PointId> skewed(count);
  std::vector<PointId> same(count, 7);
  std::vector<PointId> clumps(count);
  std::vector<PointId> ordered(count);
  for (std::size_t i = 0; i < count; ++i) {
    even[i] = static_cast<PointId>(random());
    skewed[i] = i == 0 ? 0xFFFF'FFFFU : static_cast<PointId>(random() % 100);
    clumps[i] = static_cast<PointId>(random() % 50 + (random() % 2 == 0 ? 0U : 0xFFFF'0000U));
    ordered[i] = static_cast<PointId>(3 * i);
  }
  return {even, skewed, same, clumps, ordered};
}

TEST(SortIds, BringsIdsOfAllKindsIntoOrder) {
  std::mt19937 random(1);
  for (const std::size_t count :
       {0U, 1U, 2U, 23U, 24U, 25U, 64U, 127U, 160U, 161U, 700U, 70'000U}) {
    for (const std::vector<PointId>& ids : some_ids(count, random)) {
      std::vector<PointId> truly = ids;
      std::sort(truly.begin(), truly.end());

      std::vector<PointId> given = ids;
      std::vector<PointId> spare(count);
      const PointId* const sorted = sort_ids(given.data(), spare.data(), count);
      EXPECT_EQ(std::vector<PointId>(sorted, sorted + count), truly) << count;

      std::vector<PointId> longer = ids;
      longer.push_back(0);  // not one of them
      sort_ids(longer, count);
      EXPECT_EQ(longer, truly) << count;
    }
  }
}

TEST(SortIds, EqualsTheStandardSortForAnyNumberAndRangeOfIds) {
  std::mt19937 random(1);
  for (const std::size_t count : {0U, 1U, 2U, 23U, 24U, 25U, 160U, 161U, 5000U, 70'000U}) {
    for (const unsigned bits : {3U, 8U, 20U, 32U}) {
      std::vector<PointId> ids(count + 17);
      for (PointId& id : ids) id = static_cast<PointId>(random()) >> (32 - bits);
      std::vector<PointId> expected(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(count));
      std::sort(expected.begin(), expected.end());
      sort_ids(ids, count);
      EXPECT_EQ(ids, expected) << count << " ids of " << bits << " bits";
    }
  }
}

}  // namespace
}  // namespace beespace::core
