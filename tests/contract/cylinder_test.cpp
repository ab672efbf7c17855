// Searches with a vertical threshold: every variant and every question against integers of any
// size, at the thresholds, an ulp beside them, and at all magnitudes.
#include "tests/contract/backward_crew.hpp"
#include "tests/contract/cylinder_variants.hpp"
#include "tests/support/exact_cylinder_oracle.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include "base/memory.hpp"
#include "search/cylinder_search.hpp"

#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace beespace::test {
namespace {

using search::TuningOverrides;

// Many pairs are exactly the thresholds apart: 3, 4, 5 and 5, 12, 13 on a lattice of powers of two.
TEST(CylinderContract, OnLattices) {
  SceneMaker make(20);
  for (const int power : {0, -30, 33, -380, 380}) {
    const double unit = std::ldexp(1.0, power);
    CylinderScene scene;
    scene.threshold_m = 5.0 * unit;
    scene.vertical_m = 2.0 * unit;
    for (int i = 0; i < (kSanitized ? 40 : 90); ++i) {
      const auto step = [&](std::size_t many) {
        return unit * (static_cast<double>(make.below(many)) - 0.5 * static_cast<double>(many));
      };
      scene.points.push_back({step(26), step(26), step(8)});
    }
    EXPECT_GT(check_all_forms(scene, "lattice of 2^" + std::to_string(power)), 1'000U);
  }
}

// Clumps far smaller than the thresholds, clumps about as large, and some a long way off.
TEST(CylinderContract, InCrowdsOfMixedScales) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    SceneMaker make(seed);
    CylinderScene scene;
    scene.threshold_m = 5.0;
    scene.vertical_m = seed % 2 == 0 ? 1.5 : 60.0;
    append(scene.points, make.ragged_box(40, {0, 0, 0}, {1e-6, 1e-6, 1e-6}));
    append(scene.points, make.ragged_box(40, {2, 3, 0}, {8, 9, 4}));
    append(scene.points, std::vector<Point>(12, Point{4, 4, 1.5}));
    append(scene.points, make.ragged_box(8, {-1e15, -1e15, -1e9}, {1e15, 1e15, 1e9}));
    scene.points.push_back({0x1p+399, -0x1p+399, 0x1p+390});
    scene.points.push_back({0x1p-399, -0x1p-400, 0x1p-390});
    make.shuffle(scene.points);
    EXPECT_GT(check_all_forms(scene, "crowds " + std::to_string(seed)), 1'000U);
  }
}

// Upright columns and flat discs of many more places than leaves hold.
TEST(CylinderContract, InColumnsAndDiscs) {
  SceneMaker make(7);
  CylinderScene column;
  column.threshold_m = 1.0;
  column.vertical_m = 20.0;
  column.points = make.ragged_box(150, {1e6, 1e6, 0}, {1e6 + 1.5, 1e6 + 1.5, 400});
  EXPECT_GT(check_all_forms(column, "column"), 1'000U);
  CylinderScene disc;
  disc.threshold_m = 40.0;
  disc.vertical_m = 0.25;
  disc.points = make.ragged_box(150, {-1e4, 1e4, 5e3}, {-1e4 + 200, 1e4 + 200, 5e3 + 2});
  EXPECT_GT(check_all_forms(disc, "disc"), 1'000U);
}

TEST(CylinderContract, OfNoneAndOfOne) {
  for (std::size_t size = 0; size < 3; ++size) {
    CylinderScene scene;
    scene.points.assign(size, Point{1, 2, 3});
    check(scene, false, "few");
    check(apart(scene, 1.0), false, "few, heights apart");
    check(apart(scene, 0.3048), false, "few, heights apart in feet");
    scene.two_sets = true;
    check(scene, false, "few and none");
    std::swap(scene.points, scene.others);
    check(scene, false, "none and few");
    check(apart(scene, 1.0), false, "none and few, heights apart");
    check(apart(scene, 0.3048), false, "none and few, heights apart in feet");
  }
}

struct Corner {
  double height;
  double vertical;
};

// Two points that are one ulp inside the threshold horizontally and just below the vertical one in
// height: the corner of the cylinder, which a rounded, stretched height misses.
class CornerEncounters : public testing::TestWithParam<Corner> {};

// The last height above `from` that is closer to it than `vertical`, exactly.
double just_inside(double from, double vertical) {
  const auto is_inside = [&](double height) {
    return WideInteger(scaled(height, -200)) - WideInteger(scaled(from, -200)) <
           WideInteger(scaled(vertical, -200));
  };
  double height = from + vertical;
  while (!is_inside(height)) height = one_ulp_below(height);
  return height;
}

TEST_P(CornerEncounters, AreAllFound) {
  SceneMaker make(3);
  const int encounters = rounds(40'000);
  int found = 0;
  for (int k = 0; k < encounters; ++k) {
    CylinderScene scene;
    scene.threshold_m = make.between(50.0, 200.0);
    scene.vertical_m = GetParam().vertical * make.between(0.7, 1.5);
    const double low = GetParam().height * make.between(1.0, 1.001);
    scene.points = {{0, 0, low},
                    {one_ulp_below(scene.threshold_m), 0, just_inside(low, scene.vertical_m)}};
    const SearchOptions options = scene.options(false);
    ASSERT_TRUE(ExactCylinders(scene).in_cylinder(0, 1, false));
    for (const auto crowds : {TuningOverrides::Crowds::kNever, TuningOverrides::Crowds::kAlways}) {
      BackwardCrew crew(1);
      core::Memory memory;
      const core::Resources with{crew, memory};
      TuningOverrides tuning;
      tuning.crowds = crowds;
      const PointsView points = scene.view();
      std::vector<Pair> pairs;
      const search::CylinderSearch search(points, nullptr, options, with, tuning);
      search::PairVector answer(pairs);
      ASSERT_TRUE(search.find_pairs(answer));
      found += pairs.size() == 1 ? 1 : 0;
    }
  }
  EXPECT_EQ(found, 2 * encounters);
}

INSTANTIATE_TEST_SUITE_P(Heights, CornerEncounters,
                         testing::Values(Corner{1e15, 1.0}, Corner{1e12, 1e-3}, Corner{1e11, 1.0},
                                         Corner{1e9, 0.1}, Corner{6.37e6, 1e-4},
                                         Corner{6.37e6, 1e-3}),
                         [](const auto& instance) { return std::to_string(instance.index); });

// Two points are just within a threshold along one axis, the first just below where cells of about
// that width may end: for any width of cells, they are at most one cell apart. Cells are the widest
// along the first axis, then the second, so other points there make the pair's axis the tested one.
TEST(CylinderContract, AtTheBordersOfCells) {
  constexpr double kThreshold = 1.7;
  constexpr double kVertical = 0.3;
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const double size = axis == 2 ? kVertical : kThreshold;
    for (const double wider : {-0x1p-18, -0x1p-20, -0x1p-30, 0.0, 0x1p-30, 0x1p-20, 0x1p-18}) {
      for (double cell = 1.0; cell < 1'500; cell = std::ceil(cell * 1.05)) {
        const double first = one_ulp_below(cell * (size * (1.0 + wider)));
        const double second = just_inside(first, size);
        CylinderScene scene;
        scene.threshold_m = kThreshold;
        scene.vertical_m = kVertical;
        scene.points.assign(4, Point{});
        double Point::*const along = axis == 0 ? &Point::x : axis == 1 ? &Point::y : &Point::z;
        if (axis != 0) scene.points[1].x = 3e3;
        scene.points[2].*along = first;
        scene.points[3].*along = second;
        // So few places alone would have wider cells.
        for (int k = 0; k < 2'000; ++k) scene.points.push_back({0.7 * k, 0, 0});
        BackwardCrew crew(1);
        core::Memory memory;
        const core::Resources with{crew, memory};
        TuningOverrides tuning;
        tuning.crowds = TuningOverrides::Crowds::kNever;
        const PointsView points = scene.view();
        const SearchOptions options = scene.options(false);
        std::vector<Pair> pairs;
        const search::CylinderSearch search(points, nullptr, options, with, tuning);
        search::PairVector answer(pairs);
        ASSERT_TRUE(search.find_pairs(answer));
        ASSERT_TRUE(std::count(pairs.begin(), pairs.end(), Pair{2, 3}) == 1)
            << "axis " << axis << ", cell " << cell << ", wider by " << wider;
      }
    }
  }
}

// Cases that were once missed, or refused.
TEST(CylinderContract, NamedCases) {
  CylinderScene high;
  high.points = {{0, 0, 1e15 + 0.5}, {142.79199471803761, 0, 1e15 + 1.875}};
  high.threshold_m = 142.79199471803764;
  high.vertical_m = 1.4448376891053065;
  EXPECT_EQ(check(high, false, "high"), 1U);

  CylinderScene tiny;
  tiny.points = {{0, 0, 1.9 * 0x1p-400}, {0, 0, 3.8 * 0x1p-400}};
  tiny.threshold_m = 0x1p-400;
  tiny.vertical_m = 0x1p-399;
  EXPECT_EQ(check(tiny, false, "tiny"), 1U);

  // No error about a coordinate that is not in the input.
  CylinderScene far_apart;
  far_apart.points = {{0, 0, 0}, {0, 0, 0x1p+399}};
  far_apart.threshold_m = 0x1p+20;
  far_apart.vertical_m = 1.0;
  EXPECT_EQ(check(far_apart, false, "far apart"), 0U);

  CylinderScene extremes;
  extremes.points = {{0x1p+400, -0x1p+400, 0x1p+400}, {-0x1p+400, 0x1p+400, -0x1p+400}, {0, 0, 0}};
  extremes.threshold_m = 0x1p+400;
  extremes.vertical_m = 0x1p-400;
  EXPECT_EQ(check(extremes, true, "extremes"), 0U);
}

// The straight line decides which point is nearest, not the horizontal distance, and feet become
// metres.
TEST(CylinderContract, TheNearestIsNearestByTheStraightLine) {
  CylinderScene scene;
  scene.points = {{0, 0, 0}, {1, 0, 9}, {5, 0, 1}, {0, 0, 11}};
  scene.threshold_m = 10.0;
  scene.vertical_m = 10.0;
  const auto nearest = find_nearest_within(scene.points, scene.options(false));
  ASSERT_TRUE(nearest);
  EXPECT_EQ((*nearest)[0].id, 2U) << "not 1, which is nearer horizontally";
  CylinderScene feet = apart(scene, 0.3048);
  feet.points = {{0, 0, 0}, {0, 0, 1}, {0, 0, 5}, {0, 0, 0}};
  const auto in_feet = find_nearest_within(feet.view(), feet.options(false));
  ASSERT_TRUE(in_feet);
  EXPECT_EQ((*in_feet)[0].id, 1U) << "9 feet are 2.7 m";
  EXPECT_EQ((*in_feet)[0].distance_m, std::sqrt(1.0 + (9 * 0.3048) * (9 * 0.3048)));
}

// As many results as there are is not too many; one fewer allowed is.
TEST(CylinderContract, TooManyResultsAreRefused) {
  SceneMaker make(5);
  CylinderScene scene;
  scene.points = make.box(300, {0, 0, 0}, {9, 9, 9});
  scene.threshold_m = 3.0;
  scene.vertical_m = 2.0;
  PairOptions options = scene.options(false);
  const std::size_t pairs = find_pairs(scene.points, options).value().size();
  options.max_results = pairs;
  EXPECT_TRUE(find_pairs(scene.points, options));
  EXPECT_FALSE(find_neighbors(scene.points, options));
  options.max_results = pairs - 1;
  EXPECT_EQ(find_pairs(scene.points, options).error().code, ErrorCode::kTooManyResults);
  options.max_results = 2 * pairs - 1;
  EXPECT_EQ(find_neighbors(scene.points, options).error().code, ErrorCode::kTooManyResults);
  options.max_results = 2 * pairs;
  EXPECT_TRUE(find_neighbors(scene.points, options));
}

// Enough for several workers at the same time, as rows and as trees.
TEST(CylinderContract, EveryNumberOfThreadsGivesTheSameAnswers) {
  for (const double side : {200.0, 20.0}) {
    SceneMaker make(9);
    CylinderScene scene;
    scene.threshold_m = 5.0;
    scene.vertical_m = 2.0;
    scene.points = make.ragged_box(16'000, {0, 0, 0}, {side, side, 10 * side});
    for (const CylinderScene& one : {scene, apart(scene, 1.0), in_two_sets(scene)}) {
      const Answers right = by_functions(one, one.options(false, 1));
      for (const unsigned threads : {2U, 5U}) {
        expect_same(by_functions(one, one.options(false, threads)), right,
                    std::to_string(threads) + " threads");
      }
    }
  }
}

TEST(CylinderContract, AVisitorThatHasSeenEnoughEndsIt) {
  const std::vector<Point> crowd(20'000, Point{1, 2, 3});
  for (const unsigned threads : {1U, 3U}) {
    std::size_t seen = 0;
    const SearchOptions options{.threshold_m = 5.0, .threads = threads, .vertical_m = 5.0};
    const auto all = visit_pairs(crowd, options, [&](std::span<const Pair> pairs) {
      seen += pairs.size();
      return seen < 10'000;
    });
    ASSERT_TRUE(all);
    EXPECT_FALSE(*all);
    EXPECT_LT(seen, 20'000U);
  }
}

}  // namespace
}  // namespace beespace::test
