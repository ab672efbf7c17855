// The promise the search rests on: points within the reach are in the same or adjacent cells.
#include "grid/lattice.hpp"

#include "exact/exact_distance.hpp"
#include "tests/support/own_resources.hpp"
#include "tests/support/search_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace beespace::core {
namespace {

// A lattice of one set, with the memory that it lives in.
class LatticeOf {
 public:
  LatticeOf(const PointsView& points, double reach,
            std::uint64_t fold_beyond_cells = Lattice::kFoldBeyondCells,
            std::uint64_t most_cells = Lattice::kMostCells)
      : lattice_({&points, 1}, *measure(points, own_.with), reach, own_.memory, fold_beyond_cells,
                 most_cells) {}

  const Lattice* operator->() const { return &lattice_; }

 private:
  test::OwnResources own_;
  Lattice lattice_;
};

void expect_neighbours_adjacent(const std::vector<Point>& points, double reach,
                                std::uint64_t fold_beyond) {
  const LatticeOf lattice(points, reach, fold_beyond);
  const ProximityTest within(reach, true);
  for (const Point& p : points) {
    for (const Point& q : points) {
      if (!within(p, q)) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto coordinate = [axis](const Point& point) {
          return axis == 0 ? point.x : axis == 1 ? point.y : point.z;
        };
        const auto a = static_cast<std::int64_t>(lattice->cell(axis, coordinate(p)));
        const auto b = static_cast<std::int64_t>(lattice->cell(axis, coordinate(q)));
        ASSERT_LE(std::abs(a - b), 1);
      }
    }
  }
}

TEST(Lattice, PutsNeighboursInAdjacentCellsOnEveryScene) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    if (scene.points.size() > 1000) continue;
    SCOPED_TRACE(scene.name);
    expect_neighbours_adjacent(scene.points, scene.threshold_m, Lattice::kFoldBeyondCells);
    expect_neighbours_adjacent(scene.points, scene.threshold_m, 3);
  }
}

TEST(Lattice, PutsNeighboursInAdjacentCellsWhateverTheExtent) {
  for (double extent = 1e3; extent < 1e16; extent *= 10.0) {
    test::SceneMaker make(11);
    std::vector<Point> points = {{0, 0, 0}, {extent, extent, extent}};
    for (int i = 0; i < 40; ++i) {
      const double x = make.between(0.9, 1.0) * extent;
      points.push_back({x, 0, 0});
      points.push_back({x + std::nextafter(1.0, 0.0), 0, 0});
    }
    SCOPED_TRACE(extent);
    expect_neighbours_adjacent(points, 1.0, Lattice::kFoldBeyondCells);
    expect_neighbours_adjacent(points, 1.0, std::uint64_t{1} << 29);
  }
}

// Without the margin, rounding puts one pair in some 30 million two cells apart: those that lie
// just before and just behind a cell's border, a reach from each other. Here are some that do.
TEST(Lattice, MarginOutweighsTheRoundingOfPositions) {
  const double reach = 0.007;
  const Bounds bounds{{0, 0, 0}, {0.007e6, 0, 0}};
  Memory memory;
  const Lattice lattice({}, bounds, reach, memory, std::uint64_t{1} << 29);
  for (int k = 2; k < 1'000'000; ++k) {
    const double border = k * reach;
    for (const double a : {std::nextafter(border, 0.0), border, std::nextafter(border, 1e9)}) {
      for (const double b : {a + reach, std::nextafter(a + reach, 0.0)}) {
        if (!ProximityTest(reach, true)({a, 0, 0}, {b, 0, 0})) continue;
        ASSERT_LE(lattice.cell(0, b) - lattice.cell(0, a), 1U) << k;
      }
    }
  }
}

TEST(Lattice, JoinsStretchesWhenThereAreMoreThanCells) {
  std::vector<Point> points;
  for (int i = 0; i < 2000; ++i) points.push_back({i * 1e5, 0, 0});
  for (int i = 0; i < 2000; i += 10) points.push_back({i * 1e5 + 0.9, 0, 0});
  const LatticeOf lattice(points, 1.0, 16, 1024);
  EXPECT_LE(lattice->cells(0), 1024U);
  for (int i = 0; i < 2000; i += 10) {
    ASSERT_LE(lattice->cell(0, i * 1e5 + 0.9) - lattice->cell(0, i * 1e5), 1U);
  }
}

TEST(Lattice, NumbersStayInRangeAndInOrder) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    const LatticeOf lattice(scene.points, scene.threshold_m);
    std::vector<double> xs;
    for (const Point& p : scene.points) xs.push_back(p.x);
    std::sort(xs.begin(), xs.end());
    std::int32_t last = 0;
    for (const double x : xs) {
      const std::int32_t position = lattice->position(0, x);
      ASSERT_GE(position, last);
      ASSERT_LT(lattice->cell(0, x), lattice->cells(0));
      last = position;
    }
    ASSERT_LT(last, 1 << 30);
  }
}

TEST(Lattice, EmptySpaceCostsNothing) {
  std::vector<Point> points;
  for (int power = 0; power < 300; ++power) points.push_back({std::ldexp(1.0, power), 0, 0});
  const LatticeOf lattice(points, 1.0);
  EXPECT_LE(lattice->cells(0), 8 * points.size());
}

TEST(Lattice, ManyAtOnceAreAsOneByOne) {
  test::SceneMaker make(1);
  const std::vector<Point> points = make.box(500, {-10, -10, -10}, {10, 10, 10});
  for (const std::uint64_t fold_beyond : {std::uint64_t{2}, Lattice::kFoldBeyondCells}) {
    const LatticeOf lattice(points, 0.01, fold_beyond);
    std::vector<double> ys;
    for (const Point& p : points) ys.push_back(p.y);
    std::vector<std::int32_t> positions(ys.size());
    lattice->positions(1, ys.data(), ys.size(), positions.data());
    for (std::size_t i = 0; i < ys.size(); ++i) {
      ASSERT_EQ(positions[i], lattice->position(1, ys[i]));
    }
  }
}

}  // namespace
}  // namespace beespace::core
