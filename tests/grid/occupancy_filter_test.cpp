// The filter may keep too many points, but never drops one that has a neighbour within the bound.
#include "grid/occupancy_filter.hpp"

#include "base/bounds.hpp"
#include "exact/exact_distance.hpp"
#include "tests/support/own_resources.hpp"
#include "tests/support/search_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace beespace::core {
namespace {

// Pairs just within the bound, across faces, edges and corners of cells, in boxes of all sizes: few
// units a cell where the box is large.
TEST(OccupancyFilter, KeepsEveryPairWithinTheBound) {
  const double bound = 1.0;
  for (int power = 4; power <= 26; ++power) {
    const double side = std::ldexp(1.0, power);
    test::SceneMaker make(static_cast<std::uint32_t>(power));
    std::vector<Point> points = make.box(400, {0, 0, 0}, {side, side, side});
    for (std::size_t i = 0; i < 400; ++i) {
      const Point direction{make.between(-1, 1), make.between(-1, 1), make.between(-1, 1)};
      const double length = std::sqrt(squared_distance(direction, {}));
      const double step = bound * (1.0 - 1e-9) / length;
      points.push_back({points[i].x + step * direction.x, points[i].y + step * direction.y,
                        points[i].z + step * direction.z});
    }
    for (const unsigned threads : {1U, 3U}) {
      test::OwnResources own(threads);
      const PointsView view(points);
      for (const double cell_in_bounds : {2.5, 8.0}) {
        const Lattice lattice({&view, 1}, *measure(view, own.with), cell_in_bounds * bound,
                              own.memory);
        const Vector<PointId> left = occupancy_filter(view, lattice, bound, own.with);
        const ProximityTest near(bound, true);
        for (PointId id = 0; id < 400; ++id) {
          if (!near(points[id], points[id + 400])) continue;
          ASSERT_TRUE(std::binary_search(left.begin(), left.end(), id)) << power << " " << id;
          ASSERT_TRUE(std::binary_search(left.begin(), left.end(), id + 400));
        }
      }
    }
  }
}

TEST(OccupancyFilter, DropsMostPointsWithoutNeighbours) {
  test::SceneMaker make(1);
  const std::vector<Point> points = make.box(20'000, {0, 0, 0}, {10'000, 10'000, 10'000});
  test::OwnResources own;
  const PointsView view(points);
  const Lattice lattice({&view, 1}, *measure(view, own.with), 8.0, own.memory);
  EXPECT_LT(occupancy_filter(view, lattice, 1.0, own.with).size(), points.size() / 4);
}

TEST(OccupancyFilter, KeepsAllPointsWhereItCannotTell) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {1e9, 0, 0}};
  test::OwnResources own;
  const PointsView view(points);
  const Lattice lattice({&view, 1}, *measure(view, own.with), 2.0, own.memory,
                        std::uint64_t{1} << 40);
  EXPECT_EQ(occupancy_filter(view, lattice, 1.0, own.with).size(), points.size());
}

}  // namespace
}  // namespace beespace::core
