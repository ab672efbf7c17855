#include "grid/sorted_grid.hpp"

#include "exact/exact_distance.hpp"
#include "grid/cell_order.hpp"
#include "grid/near_pairs.hpp"
#include "tests/support/search_scenes.hpp"

#include <beespace/crew.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>

namespace beespace::core {
namespace {

class EveryScene : public testing::TestWithParam<unsigned> {
 protected:
  template <class Check>
  void for_each_grid(Check&& check) {
    ThreadCrew crew(GetParam());
    Memory memory;
    const Resources with{crew, memory};
    for (const test::SearchScene& scene : test::search_scenes()) {
      for (const std::uint64_t fold_beyond : {std::uint64_t{4}, Lattice::kFoldBeyondCells}) {
        SCOPED_TRACE(scene.name);
        const PointsView points(scene.points);
        const Bounds bounds = *measure(points, with);
        const Lattice lattice({&points, 1}, bounds, scene.threshold_m, memory, fold_beyond);
        for (const unsigned row_shift : {0U, 1U, 3U}) {
          SCOPED_TRACE(row_shift);
          check(scene, lattice, sort_into_grid({points}, lattice, row_shift, with));
        }
      }
    }
  }
};

TEST_P(EveryScene, HoldsEveryPointOnceInTheOrderOfRowsAndSlices) {
  for_each_grid([](const test::SearchScene& scene, const Lattice& lattice, const SortedGrid& grid) {
    ASSERT_EQ(grid.size, scene.points.size());
    std::vector<bool> seen(grid.size, false);
    const CellOrder order(lattice, grid.row_shift);
    std::pair<std::uint64_t, std::int32_t> last{0, 0};
    for (std::size_t i = 0; i < grid.size; ++i) {
      const PointId id = grid.id[i];
      ASSERT_FALSE(seen[id]);
      seen[id] = true;
      const Point& p = scene.points[id];
      ASSERT_EQ(grid.x[i], lattice.position(0, p.x));
      ASSERT_EQ(grid.y[i], lattice.position(1, p.y));
      ASSERT_EQ(grid.z[i], lattice.position(2, p.z));
      const std::pair place{order.row(grid.y[i], grid.z[i]), grid.x[i] >> grid.slice_bits};
      ASSERT_GE(place, last);
      last = place;
    }
  });
}

TEST_P(EveryScene, RowsAreTheRunsOfEqualYAndZ) {
  for_each_grid([](const test::SearchScene& scene, const Lattice& lattice, const SortedGrid& grid) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> expected;
    for (const Point& p : scene.points) {
      ++expected[{lattice.cell(2, p.z) >> grid.row_shift, lattice.cell(1, p.y) >> grid.row_shift}];
    }
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
  Memory memory;
  const Resources with{alone, memory};
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
    const PointsView view(points);
    const Lattice lattice({&view, 1}, *measure(view, with), 1.0, memory, std::uint64_t{1} << 29);
    const SortedGrid grid = sort_into_grid({view}, lattice, 0, with);
    const SquaredLimits limits(1.0, grid.units_per_m);
    std::vector<std::size_t> place(points.size());
    for (std::size_t i = 0; i < grid.size; ++i) place[grid.id[i]] = i;
    for (std::size_t i = 0; i < 300; ++i) {
      const float squared = squared_units(grid, place[i], grid, place[i + 300]);
      const bool near = ProximityTest(1.0, false)(points[i], points[i + 300]);
      ASSERT_TRUE(near || squared >= limits.surely_near) << power;
      ASSERT_TRUE(!near || squared <= limits.surely_far) << power;
      sure += squared < limits.surely_near || squared > limits.surely_far ? 1U : 0U;
    }
  }
  EXPECT_GT(sure, 3000U);
}

INSTANTIATE_TEST_SUITE_P(Crews, EveryScene, testing::Values(1U, 3U));

class Sorting : public testing::Test {
 protected:
  SortedGrid sorted(const PointsView& points, double reach,
                    std::optional<std::span<const PointId>> ids = {}) {
    const Resources with{alone_, memory_};
    const Lattice lattice({&points, 1}, *measure(points, with), reach, memory_);
    key_bits_ = CellOrder(lattice, 0).key_bits();
    return sort_into_grid({points, ids}, lattice, 0, with);
  }

  static void expect_sorted(const SortedGrid& grid, std::size_t size) {
    std::vector<bool> seen(size, false);
    for (std::size_t row = 0; row < grid.rows(); ++row) {
      if (row > 0) {
        ASSERT_LT(grid.row_number[row - 1], grid.row_number[row]);
      }
      for (std::uint32_t i = grid.row_begin[row]; i < grid.row_begin[row + 1]; ++i) {
        ASSERT_FALSE(seen[grid.id[i]]);
        seen[grid.id[i]] = true;
        if (i == grid.row_begin[row]) continue;
        ASSERT_LE(grid.x[i - 1] >> grid.slice_bits, grid.x[i] >> grid.slice_bits);
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), true), static_cast<std::ptrdiff_t>(grid.size));
  }

  Crew alone_;
  Memory memory_;
  unsigned key_bits_ = 0;
};

TEST_F(Sorting, OfASubsetHoldsThatSubset) {
  test::SceneMaker make(2);
  const std::vector<Point> points = make.box(5000, {0, 0, 0}, {100, 100, 100});
  std::vector<PointId> subset;
  for (PointId id = 3; id < 5000; id += 7) subset.push_back(id);
  const SortedGrid grid = sorted(points, 5.0, subset);
  std::vector<PointId> ids(grid.id, grid.id + grid.size);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, subset);
  EXPECT_EQ(sorted(points, 5.0, std::span<const PointId>()).size, 0U);
}

// Buckets of many points take the counting sort, and wide keys take several passes of it.
TEST_F(Sorting, SortsBucketsByWideKeys) {
  test::SceneMaker make(4);
  std::vector<Point> points = make.box(40'000, {0, 0, 0}, {3000, 3000, 3000});
  points.push_back({1e5, 1e5, 1e5});
  expect_sorted(sorted(points, 1.0), points.size());
  EXPECT_GT(key_bits_, 40U);
}

// A crowd in a wide space falls into one bucket, which is split in place.
TEST_F(Sorting, SplitsBucketsThatAreTooLarge) {
  test::SceneMaker make(5);
  std::vector<Point> points = make.box(100'000, {0, 0, 0}, {300, 300, 300});
  points.push_back({1e5, 1e5, 1e5});
  expect_sorted(sorted(points, 1.0), points.size());
}

}  // namespace
}  // namespace beespace::core
