#include "core/sort_ids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace beespace::core {
namespace {

TEST(SortIds, EqualsTheStandardSortForAnyNumberAndRangeOfIds) {
  std::mt19937 random(1);
  for (const std::size_t count : {0U, 1U, 2U, 127U, 128U, 129U, 5000U, 70'000U}) {
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
