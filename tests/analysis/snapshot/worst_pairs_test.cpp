// The pairs that a page shows: all of them, or of very many exactly the closest.
#include "analysis/snapshot/worst_pairs.hpp"

#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/nearest.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace beespace::analysis {
namespace {

using test::kSanitized;
using test::rounds;
using test::SceneMaker;
using Points = std::vector<Point>;

WorstPairs found(const PointsView& places, const Points& points, const SearchOptions& options) {
  Engine engine;
  auto worst = worst_pairs(engine, places, points, options);
  EXPECT_TRUE(worst.has_value());
  return worst ? *std::move(worst) : WorstPairs{};
}

// The answer by brute force.
WorstPairs expected(const PointsView& places, const Points& points, const SearchOptions& options) {
  const auto pairs = brute_force::find_pairs(places, options);
  EXPECT_TRUE(pairs.has_value());
  std::vector<std::pair<double, Pair>> all;
  for (const Pair& pair : *pairs) {
    all.emplace_back(distance(points[pair.first], points[pair.second]), pair);
  }
  std::sort(all.begin(), all.end());
  WorstPairs worst;
  worst.count = all.size();
  if (all.size() > 200'000) all.resize(10'000);
  for (const auto& [apart_m, pair] : all) {
    worst.pairs.push_back(pair);
    worst.distances_m.push_back(apart_m);
  }
  return worst;
}

void expect_same(const WorstPairs& worst, const WorstPairs& other) {
  EXPECT_EQ(worst.count, other.count);
  EXPECT_TRUE(worst.pairs == other.pairs);
  EXPECT_TRUE(worst.distances_m == other.distances_m);
}

// Returns how many pairs there are.
std::uint64_t expect_as_brute_force(const Points& points, const SearchOptions& options) {
  const WorstPairs worst = found(points, points, options);
  expect_same(worst, expected(points, points, options));
  return worst.count;
}

// So many points, with about so many others closer than 1 m to each.
Points crowd(SceneMaker& make, std::size_t count, double neighbors) {
  const double volume_m3 = static_cast<double>(count) / neighbors * 4.0 / 3.0 * std::numbers::pi;
  const double side_m = std::cbrt(volume_m3);
  return make.ragged_box(count, {0, 0, 0}, {side_m, side_m, side_m});
}

TEST(WorstPairs, AreThoseOfBruteForceHoweverManyThereAre) {
  SceneMaker make(1);
  const std::size_t count = kSanitized ? 1'200 : 1'500;
  std::uint64_t fewest = kAllPairs;
  std::uint64_t most = 0;
  for (const double neighbors : {0.1, 1.0, 30.0, 400.0, 1'000.0, 3'000.0}) {
    for (const unsigned threads : {1u, 3u}) {
      const std::uint64_t pairs = expect_as_brute_force(crowd(make, count, neighbors),
                                                        {.threshold_m = 1.0, .threads = threads});
      fewest = std::min(fewest, pairs);
      most = std::max(most, pairs);
    }
  }
  EXPECT_LT(fewest, 1'000u);
  EXPECT_GT(most, 2 * kAllPairs);
}

TEST(WorstPairs, AreThoseOfBruteForceWhereverTheCrowdIs) {
  SceneMaker make(2);
  for (int round = 0; round < rounds(20); ++round) {
    Points points = crowd(make, 300 + make.below(150), make.between(300.0, 3'000.0));
    test::append(points, crowd(make, 300, 0.1));
    for (Point& p : points) p = test::shifted(p, {-1e6, 1e6, 0});
    make.shuffle(points);
    expect_as_brute_force(
        points, {.threshold_m = make.between(0.5, 100.0), .inclusive = make.below(2) == 0});
  }
}

// Bees with whole coordinates: very many are exactly equally far apart.
Points lattice(int along_x, int along_y, int along_z) {
  Points points;
  for (int x = 0; x < along_x; ++x) {
    for (int y = 0; y < along_y; ++y) {
      for (int z = 0; z < along_z; ++z) {
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  return points;
}

TEST(WorstPairs, OfEquallyCloseOnesThoseOfTheLowestIdsAreShown) {
  SceneMaker make(3);
  Points points = lattice(12, 12, 8);
  make.shuffle(points);
  for (const double threshold_m : {1.0, 2.0, 5.0, 9.0, 20.0}) {
    for (const bool inclusive : {false, true}) {
      expect_as_brute_force(points, {.threshold_m = threshold_m, .inclusive = inclusive});
    }
  }
}

TEST(WorstPairs, ExactlyTheThresholdCountsOnlyWhenInclusive) {
  const Points points = lattice(10, 10, 10);
  EXPECT_EQ(found(points, points, {.threshold_m = 1.0}).count, 0u);
  const WorstPairs inclusive = found(points, points, {.threshold_m = 1.0, .inclusive = true});
  EXPECT_EQ(inclusive.count, 2'700u);
  EXPECT_EQ(inclusive.pairs.size(), 2'700u);
}

TEST(WorstPairs, AThousandAtOnePlaceAreAllEquallyClose) {
  const Points points(1'000, Point{3.0, -2.0, 1e5});
  const WorstPairs worst = found(points, points, {.threshold_m = 1.0});
  EXPECT_EQ(worst.count, 499'500u);
  ASSERT_EQ(worst.pairs.size(), kWorstPairs);
  std::size_t next = 0;
  for (PointId first = 0; next < worst.pairs.size(); ++first) {
    for (PointId second = first + 1; second < 1'000 && next < worst.pairs.size(); ++second) {
      ASSERT_EQ(worst.pairs[next], (Pair{first, second}));
      ASSERT_EQ(worst.distances_m[next], 0.0);
      ++next;
    }
  }
}

// No smaller threshold has more than none and fewer than too many.
TEST(WorstPairs, ALatticeOfOneDistanceIsShownInTheOrderOfIds) {
  if (kSanitized) GTEST_SKIP() << "too many for a sanitizer";
  constexpr int kSide = 42;
  const Points points = lattice(kSide, kSide, kSide);
  for (const bool inclusive : {false, true}) {
    const WorstPairs worst =
        found(points, points, {.threshold_m = inclusive ? 1.0 : 1.25, .inclusive = inclusive});
    EXPECT_EQ(worst.count, 3u * kSide * kSide * (kSide - 1));
    ASSERT_EQ(worst.pairs.size(), kWorstPairs);
    std::size_t next = 0;
    for (PointId id = 0; next < worst.pairs.size(); ++id) {
      const Point& p = points[id];
      const auto expect_next = [&](double along, PointId step) {
        if (along + 1 == kSide || next == worst.pairs.size()) return;
        EXPECT_EQ(worst.pairs[next++], (Pair{id, id + step}));
      };
      expect_next(p.z, 1);
      expect_next(p.y, kSide);
      expect_next(p.x, kSide * kSide);
    }
    EXPECT_EQ(worst.distances_m.front(), 1.0);
    EXPECT_EQ(worst.distances_m.back(), 1.0);
  }
}

TEST(WorstPairs, ExactlySoManyAreAllShownAndOneMoreIsNot) {
  // 633 at one place are 200,028 pairs; take those apart that are too many.
  const auto pairs_of = [](std::size_t at_once, std::size_t in_twos) {
    Points points(at_once, Point{0, 0, 0});
    for (std::size_t i = 0; i < in_twos; ++i) {
      const double x = 10.0 * static_cast<double>(i + 1);
      test::append(points, {{x, 0, 0}, {x + 0.5, 0, 0}});
    }
    return points;
  };
  const Points enough = pairs_of(632, 604);  // 199,396 + 604
  const WorstPairs all = found(enough, enough, {.threshold_m = 1.0});
  EXPECT_EQ(all.count, kAllPairs);
  EXPECT_EQ(all.pairs.size(), kAllPairs);
  const Points more = pairs_of(632, 605);
  const WorstPairs some = found(more, more, {.threshold_m = 1.0});
  EXPECT_EQ(some.count, kAllPairs + 1);
  EXPECT_EQ(some.pairs.size(), kWorstPairs);
}

TEST(WorstPairs, WithAVerticalThresholdAreThoseOfBruteForce) {
  SceneMaker make(4);
  for (const double size_m : {3.0, 30.0}) {
    const Points points = make.ragged_box(1'200, {0, 0, 0}, {size_m, size_m, 0.5 * size_m});
    for (const bool inclusive : {false, true}) {
      expect_as_brute_force(points,
                            {.threshold_m = 2.5, .inclusive = inclusive, .vertical_m = 1.0});
    }
  }
}

// As of geographic positions: on the ground, with heights beside them, and in space.
TEST(WorstPairs, MayUseOtherPlacesThanTheirDistances) {
  SceneMaker make(5);
  for (const double size_m : {3.0, 30.0}) {
    const Points points = make.ragged_box(1'200, {0, 0, 0}, {size_m, size_m, size_m});
    Points ground;
    std::vector<double> heights_m;
    for (const Point& p : points) {
      ground.push_back({1.01 * p.x, 0.99 * p.y, 7.0});
      heights_m.push_back(p.z);
    }
    SearchOptions options;
    options.threshold_m = 2.0;
    options.vertical_m = 1.5;
    const PointsView apart = PointsView(ground).with_heights(heights_m);
    const WorstPairs worst = found(apart, points, options);
    expect_same(worst, expected(apart, points, options));
    EXPECT_EQ(worst.count > kAllPairs, size_m < 10.0);
  }
}

TEST(WorstPairs, OfFewerThanTwoThereAreNone) {
  for (const std::size_t count : {0u, 1u}) {
    const Points points(count);
    const WorstPairs worst = found(points, points, {.threshold_m = 1.0});
    EXPECT_EQ(worst.count, 0u);
    EXPECT_TRUE(worst.pairs.empty() && worst.distances_m.empty());
  }
}

TEST(WorstPairs, AnErrorOfTheSearchIsThatOfTheQuestion) {
  Engine engine;
  const Points points(2);
  const auto none = worst_pairs(engine, points, points, {.threshold_m = -1.0});
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ErrorCode::kInvalidThreshold);
}

}  // namespace
}  // namespace beespace::analysis
