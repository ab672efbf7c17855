// The list keeps the exact nearest points, whatever the order in which it gets them.
#include "tree/nearest_list.hpp"

#include "exact/exact_distance.hpp"
#include "tests/support/search_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace beespace::core {
namespace {

std::vector<Nearest> nearest_of(const std::vector<Point>& points, const Point& place,
                                std::size_t k) {
  NearestList list;
  list.start(place, k, std::numeric_limits<double>::infinity());
  for (PointId id = 0; id < points.size(); ++id) {
    list.offer(points[id], id, squared_distance(points[id], place));
  }
  std::vector<Nearest> nearest(k);
  nearest.resize(list.write(nearest.data()));
  return nearest;
}

// Neighbouring doubles at a distance whose square rounds alike: only exact arithmetic sees them
// apart.
TEST(NearestList, OrdersWhatRoundingCannotTellApart) {
  std::vector<Point> points;
  double z = 1e-8;
  for (int i = 0; i < 40; ++i, z = std::nextafter(z, 1.0)) points.push_back({1000, 0, z});
  std::vector<PointId> place_of(points.size());
  std::vector<Point> shuffled = points;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
  ASSERT_EQ(squared_distance(points.front(), {}), squared_distance(points.back(), {}));
  for (const std::size_t k : {1U, 5U, 40U}) {
    const std::vector<Nearest> nearest = nearest_of(shuffled, {}, k);
    ASSERT_EQ(nearest.size(), k);
    for (std::size_t i = 0; i < k; ++i) EXPECT_EQ(shuffled[nearest[i].id], points[i]) << i;
  }
}

TEST(NearestList, ManyAreKeptAsExactlyAsFew) {
  std::vector<Point> points = test::integer_lattice(9, 1.0, {-4, -4, -4});
  std::shuffle(points.begin(), points.end(), std::mt19937(4));
  const std::vector<Nearest> all = nearest_of(points, {}, points.size());
  for (std::size_t i = 1; i < all.size(); ++i) {
    ASSERT_TRUE(all[i - 1].distance_m < all[i].distance_m ||
                (all[i - 1].distance_m == all[i].distance_m && all[i - 1].id < all[i].id));
  }
  for (const std::size_t k : {1U, 2U, 127U, 128U, 129U, 500U}) {
    const std::vector<Nearest> some = nearest_of(points, {}, k);
    ASSERT_EQ(some, std::vector<Nearest>(all.begin(), all.begin() + static_cast<long>(k)));
  }
}

TEST(NearestList, LimitsNeverLeaveOutEquallyNearPoints) {
  NearestList list;
  const Point point{3, 4, 0};
  list.start({}, 1, std::numeric_limits<double>::infinity());
  list.offer(point, 9, 25.0);
  EXPECT_GE(list.reach_m(), 5.0);
  EXPECT_GE(list.largest_squared, 25.0);
  EXPECT_TRUE(list.would_take({0, 5, 0}, 8));
  EXPECT_FALSE(list.would_take({0, 5, 0}, 10));
}

}  // namespace
}  // namespace beespace::core
