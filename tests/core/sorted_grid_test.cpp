#include "core/sorted_grid.hpp"

#include "core/cell_sort.hpp"
#include "core/exact_distance.hpp"
#include "core/near_pairs.hpp"
#include <beespace/crew.hpp>
#include "tests/support/search_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace beespace::core {
namespace {

class EveryScene : public testing::TestWithParam<unsigned> {
 protected:
  template <class Check>
  void for_each_grid(Check&& check) {
    ThreadCrew crew(GetParam());
    for (const test::SearchScene& scene : test::search_scenes()) {
      for (const std::uint64_t fold_beyond : {std::uint64_t{4}, Lattice::kFoldBeyondCells}) {
        SCOPED_TRACE(scene.name);
        const Bounds bounds = *measure(scene.points, crew);
        const Lattice lattice(scene.points, bounds, scene.threshold_m, fold_beyond);
        check(scene, lattice, sort_into_grid(scene.points, {}, lattice, crew));
      }
    }
  }
};

TEST_P(EveryScene, HoldsEveryPointOnceInTheOrderOfItsCell) {
  for_each_grid([](const test::SearchScene& scene, const Lattice& lattice, const SortedGrid& grid) {
    ASSERT_EQ(grid.size, scene.points.size());
    std::vector<bool> seen(grid.size, false);
    std::array<std::uint64_t, 3> last{0, 0, 0};
    for (std::size_t i = 0; i < grid.size; ++i) {
      const PointId id = grid.id[i];
      ASSERT_FALSE(seen[id]);
      seen[id] = true;
      const Point& p = scene.points[id];
      ASSERT_EQ(grid.x[i], lattice.position(0, p.x));
      ASSERT_EQ(grid.y[i], lattice.position(1, p.y));
      ASSERT_EQ(grid.z[i], lattice.position(2, p.z));
      const std::array<std::uint64_t, 3> cell{lattice.cell(2, p.z), lattice.cell(1, p.y),
                                              lattice.cell(0, p.x)};
      ASSERT_GE(cell, last);
      if (i > 0 && cell == last) {
        ASSERT_GT(id, grid.id[i - 1]);
      }
      last = cell;
    }
  });
}

TEST_P(EveryScene, RowsAreTheRunsOfEqualYAndZ) {
  for_each_grid([](const test::SearchScene& scene, const Lattice& lattice, const SortedGrid& grid) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> expected;
    for (const Point& p : scene.points) ++expected[{lattice.cell(2, p.z), lattice.cell(1, p.y)}];
    ASSERT_EQ(grid.rows(), expected.size());
    std::size_t row = 0;
    for (const auto& [zy, count] : expected) {
      ASSERT_EQ(grid.row_begin[row + 1] - grid.row_begin[row], count);
      ASSERT_EQ(grid.row_number[row], zy.first * grid.rows_a_layer + zy.second + 1);
      ++row;
    }
  });
}

TEST_P(EveryScene, NearPairsVisitEveryPairWithinTheReachOnce) {
  for_each_grid([](const test::SearchScene& scene, const Lattice&, const SortedGrid& grid) {
    const SquaredLimits limits(scene.threshold_m, grid.units_per_m);
    std::set<std::pair<PointId, PointId>> visited;
    const ProximityTest within(scene.threshold_m, true);
    for_each_near_pair(
        grid, limits.surely_far, [&](std::uint32_t i, std::uint32_t j, float squared) {
          const std::pair<PointId, PointId> pair = std::minmax(grid.id[i], grid.id[j]);
          ASSERT_TRUE(visited.insert(pair).second);
          const bool near = within(scene.points[pair.first], scene.points[pair.second]);
          if (squared < limits.surely_near) {
            ASSERT_TRUE(near);
          }
        });
    for (PointId i = 0; i < scene.points.size(); ++i) {
      for (PointId j = i + 1; j < scene.points.size(); ++j) {
        if (!within(scene.points[i], scene.points[j])) continue;
        ASSERT_EQ(visited.count({i, j}), 1U) << i << " " << j;
      }
    }
  });
}

// Few units a cell, and distances at the reach: what is called sure must be true.
TEST(SquaredLimits, AreRightWhereAUnitIsCoarse) {
  Crew alone;
  std::size_t sure = 0;
  for (int power = 10; power <= 28; ++power) {
    test::SceneMaker make(static_cast<std::uint32_t>(power));
    const double side = std::ldexp(1.0, power);
    std::vector<Point> points = make.box(300, {0, 0, 0}, {side, side, side});
    for (std::size_t i = 0; i < 300; ++i) {
      const Point d{make.between(-1, 1), make.between(-1, 1), make.between(-1, 1)};
      const double scale = make.between(0.9, 1.1) / std::sqrt(squared_distance(d, {}));
      points.push_back(
          {points[i].x + scale * d.x, points[i].y + scale * d.y, points[i].z + scale * d.z});
    }
    const Lattice lattice(points, *measure(points, alone), 1.0, std::uint64_t{1} << 29);
    const SortedGrid grid = sort_into_grid(points, {}, lattice, alone);
    const SquaredLimits limits(1.0, grid.units_per_m);
    std::vector<std::size_t> place(points.size());
    for (std::size_t i = 0; i < grid.size; ++i) place[grid.id[i]] = i;
    for (std::size_t i = 0; i < 300; ++i) {
      const float squared = squared_units(grid, place[i], place[i + 300]);
      const bool near = ProximityTest(1.0, false)(points[i], points[i + 300]);
      ASSERT_TRUE(near || squared >= limits.surely_near) << power;
      ASSERT_TRUE(!near || squared <= limits.surely_far) << power;
      sure += squared < limits.surely_near || squared > limits.surely_far ? 1U : 0U;
    }
  }
  EXPECT_GT(sure, 3000U);
}

INSTANTIATE_TEST_SUITE_P(Crews, EveryScene, testing::Values(1U, 3U));

TEST(SortedGrid, OfASubsetHoldsThatSubset) {
  test::SceneMaker make(2);
  const std::vector<Point> points = make.box(5000, {0, 0, 0}, {100, 100, 100});
  Crew alone;
  const Lattice lattice(points, *measure(points, alone), 5.0);
  std::vector<PointId> subset;
  for (PointId id = 3; id < 5000; id += 7) subset.push_back(id);
  const SortedGrid grid = sort_into_grid(points, subset, lattice, alone);
  std::vector<PointId> ids(grid.id, grid.id + grid.size);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, subset);
}

// Buckets of many points take the counting sort, and wide keys take several passes of it.
TEST(CellSort, SortsLargeBucketsByWideKeys) {
  test::SceneMaker make(4);
  std::vector<Point> points = make.box(40'000, {0, 0, 0}, {3000, 3000, 3000});
  points.push_back({1e6, 1e6, 1e6});
  Crew alone;
  const Lattice lattice(points, *measure(points, alone), 1.0);
  const CellOrder order(lattice);
  EXPECT_GT(order.key_bits(), 40U);
  const Buffer<CellRecord> records = sort_by_cell(points, {}, lattice, order, 0, alone).records;
  EXPECT_TRUE(std::is_sorted(records.data(), records.data() + points.size(), order));
}

}  // namespace
}  // namespace beespace::core
