// Queries of a map allocate no memory.
#include "obstacles/obstacle_map.hpp"

#include "tests/obstacles/random_obstacles.hpp"
#include "tests/support/allocation_count.hpp"

#include <gtest/gtest.h>

namespace beespace {
namespace {

TEST(ObstacleMapAllocation, LookingAroundAllocatesNothing) {
  scenes::RandomStream random(4);
  const auto map = *ObstacleMap::of(test::random_obstacles(random, 500, 30.0));
  std::size_t visited = 0;
  const auto before = test::allocations();
  for (int i = 0; i < 100; ++i) {
    const Point center = test::random_place(random, 30.0);
    map.state().visit_near(core::vector_of(center), 10.0,
                           [&](const obstacles::ConvexPiece&) { ++visited; });
    visited += map.nearest(center)->obstacle;
  }
  EXPECT_EQ(test::allocations(), before);
  EXPECT_GT(visited, 100U);
}

}  // namespace
}  // namespace beespace
