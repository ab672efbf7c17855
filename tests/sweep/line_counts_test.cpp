// Clumps that are tiny next to their distance, about a threshold apart: sorted along the line
// between them, pairs are as many as when they are compared one by one, at the threshold and one
// ulp either side.
#include "sweep/line_counts.hpp"

#include "search/pair_search.hpp"
#include "search/search_domain.hpp"
#include "tests/support/own_resources.hpp"
#include "tests/support/search_scenes.hpp"

#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace beespace::cpu {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct TwoClumps {
  std::vector<Point> first;
  std::vector<Point> second;
  double threshold;
};

Point moved(const Point& p, const Point& by) {
  return {p.x + by.x, p.y + by.y, p.z + by.z};
}

std::vector<Point> clump(test::SceneMaker& make, std::size_t size, double side, const Point& at) {
  std::vector<Point> points = make.box(size, {0, 0, 0}, {side, side, side});
  for (Point& p : points) p = moved(p, at);
  return points;
}

// The distance of a point of each is the threshold, or nearly so.
TwoClumps two_clumps(std::uint32_t seed, double side) {
  test::SceneMaker make(seed);
  const std::size_t size = 100 + 50 * (seed % 5);
  const Point way =
      seed % 3 == 0 ? Point{1, 0, 0} : Point{make.between(-1, 1), make.between(-1, 1), 1.0};
  const Point at = seed % 2 == 0 ? Point{} : Point{make.between(-9, 9), 5.0, -7.0};
  TwoClumps clumps{clump(make, size, side, at), clump(make, size + 30, side, moved(at, way)), 1.0};
  // Some exactly as far from each other as the places of the clumps.
  for (std::size_t i = 0; i < 20; ++i) clumps.second.push_back(moved(clumps.first[i], way));
  clumps.threshold = std::sqrt(core::squared_distance(clumps.first[3], clumps.second[size + 33]));
  return clumps;
}

std::vector<double> around(double threshold) {
  return {threshold, std::nextafter(threshold, kInfinity), std::nextafter(threshold, 0.0)};
}

constexpr double kSides[] = {1e-4, 1e-6, 1e-9, 1e-12, 1e-15};

std::vector<std::uint32_t> weights_of(const core::BoxTree& tree) {
  std::vector<std::uint32_t> weights(tree.size());
  for (std::size_t slot = 0; slot < tree.size(); ++slot) weights[slot] = 1 + tree.index(slot) % 3;
  return weights;
}

struct Sums {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> second;
};

Sums compared_one_by_one(const LineSide& one, const LineSide& two,
                         const core::ProximityTest& closer) {
  Sums sums{std::vector<std::uint32_t>(one.end()), std::vector<std::uint32_t>(two.end())};
  for (std::size_t i = 0; i < one.end(); ++i) {
    for (std::size_t k = 0; k < two.end(); ++k) {
      if (!closer(one.tree.point(i), two.tree.point(k))) continue;
      sums.first[i] += two.weights[k];
      sums.second[k] += one.weights[i];
    }
  }
  return sums;
}

void expect_all_counted(const TwoClumps& clumps, double threshold, bool inclusive) {
  test::OwnResources own;
  const core::BoxTree one(clumps.first, own.with);
  const core::BoxTree two(clumps.second, own.with);
  const std::vector<std::uint32_t> weights = weights_of(one);
  const std::vector<std::uint32_t> other_weights = weights_of(two);
  Sums sums{std::vector<std::uint32_t>(one.size()), std::vector<std::uint32_t>(two.size())};
  const core::ProximityTest closer(threshold, inclusive);
  LineCounts counts(threshold, closer, own.memory);
  const LineSide first{one, one.root(), weights.data(), sums.first.data()};
  const LineSide second{two, two.root(), other_weights.data(), sums.second.data()};
  ASSERT_TRUE(counts.suits(one.box(one.root()), two.box(two.root())));
  if (!counts.count(first, second)) {
    EXPECT_EQ(sums.first, std::vector<std::uint32_t>(one.size()));
    EXPECT_EQ(sums.second, std::vector<std::uint32_t>(two.size()));
    return;
  }
  const Sums truly = compared_one_by_one(first, second, closer);
  EXPECT_EQ(sums.first, truly.first);
  EXPECT_EQ(sums.second, truly.second);
}

TEST(LineCounts, AreThoseOfPairsOneByOne) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    for (const double side : kSides) {
      SCOPED_TRACE(std::to_string(seed) + ", " + std::to_string(std::log10(side)));
      const TwoClumps clumps = two_clumps(seed, side);
      for (const double threshold : around(clumps.threshold)) {
        for (const bool inclusive : {false, true}) {
          expect_all_counted(clumps, threshold, inclusive);
        }
      }
    }
  }
}

// Of each point, all but a few of the other clump are told apart.
TEST(LineCounts, DoNotGiveUpOnClumps) {
  test::SceneMaker make(1);
  test::OwnResources own;
  const core::BoxTree one(clump(make, 2'000, 1e-9, {}), own.with);
  const core::BoxTree two(clump(make, 2'000, 1e-9, {0.6, 0.0, 0.8}), own.with);
  const std::vector<std::uint32_t> ones(2'000, 1);
  std::vector<std::uint32_t> sums(2'000);
  const core::ProximityTest closer(1.0, false);
  LineCounts counts(1.0, closer, own.memory);
  EXPECT_TRUE(counts.count({one, one.root(), ones.data(), sums.data()},
                           {two, two.root(), ones.data(), nullptr}));
}

TEST(LineCounts, DoNotSuitWhatIsLargeForItsDistance) {
  const core::ProximityTest closer(1.0, false);
  test::OwnResources own;
  const LineCounts counts(1.0, closer, own.memory);
  EXPECT_FALSE(counts.suits({{0, 0, 0}, {0, 0.01, 0}}, {{1, 0, 0}, {1, 0, 0}}));
}

std::vector<std::uint32_t> counted(const PointsView& points, const SearchOptions& options) {
  test::OwnResources own(options.threads);
  search::TuningOverrides tuning;
  tuning.crowds = search::TuningOverrides::Crowds::kAlways;
  tuning.crowd_decisions = 0;  // so that boxes of doubles count
  std::vector<std::uint32_t> counts;
  search::count_neighbors(*search::SearchDomain::of(points, own.with), options, own.with, tuning,
                          counts);
  return counts;
}

TEST(LineCounts, MakeTheAnswerOfBruteForce) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    for (const double side : kSides) {
      SCOPED_TRACE(std::to_string(seed) + ", " + std::to_string(std::log10(side)));
      const TwoClumps clumps = two_clumps(seed, side);
      std::vector<Point> points = clumps.first;
      points.insert(points.end(), clumps.second.begin(), clumps.second.end());
      points.insert(points.end(), clumps.second.begin(), clumps.second.end() - 50);  // twins
      for (const double threshold : around(clumps.threshold)) {
        SearchOptions options{threshold};
        options.inclusive = seed % 2 == 0;
        options.threads = 1 + seed % 3;
        EXPECT_EQ(counted(points, options), *brute_force::count_neighbors(points, options));
      }
    }
  }
}

}  // namespace
}  // namespace beespace::cpu
