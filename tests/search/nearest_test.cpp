// Nearest and closest pair: equal to brute force, ties to the lowest id.
#include "tests/support/search_scenes.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/nearest.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace beespace {
namespace {

void expect_same_pair(const std::vector<Point>& points, unsigned threads) {
  const auto expected = *brute_force::find_closest_pair(points);
  const auto found = *find_closest_pair(points, threads);
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (!found) return;
  EXPECT_EQ(found->first, expected->first);
  EXPECT_EQ(found->second, expected->second);
  EXPECT_EQ(found->distance_m, expected->distance_m);
}

TEST(ClosestPair, EqualsBruteForceOnEveryScene) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    expect_same_pair(scene.points, 1);
    expect_same_pair(scene.points, 4);
  }
}

TEST(ClosestPair, EqualsBruteForceOnManyRandomSwarms) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    test::SceneMaker make(seed);
    const double flatness = seed % 3 == 0 ? 0.0 : make.between(0.0, 100.0);
    expect_same_pair(make.box(300 + 10 * seed, {0, 0, 0}, {100, 100, flatness}), seed % 3);
  }
}

TEST(ClosestPair, NeedsTwoPoints) {
  EXPECT_FALSE(find_closest_pair(std::vector<Point>{}).value().has_value());
  EXPECT_FALSE(find_closest_pair(std::vector<Point>{{1, 2, 3}}).value().has_value());
}

TEST(ClosestPair, ManyEquallyCloseGiveTheLowestIds) {
  const std::vector<Point> lattice = test::integer_lattice(24, 2.5, {0, 0, 0});
  const ClosestPair pair = **find_closest_pair(lattice, 2);
  EXPECT_EQ(pair.first, 0U);
  EXPECT_EQ(pair.second, 1U);
  EXPECT_EQ(pair.distance_m, 2.5);
}

TEST(ClosestPair, ManyDuplicatesGiveTheLowestIds) {
  std::vector<Point> points = test::SceneMaker(1).box(20'000, {0, 0, 0}, {1000, 1000, 1000});
  for (std::size_t i = 10'000; i < 20'000; ++i) points[i] = points[3 + i * 7 % 9000];
  const auto pair = **find_closest_pair(points);
  EXPECT_EQ(pair.distance_m, 0.0);
  EXPECT_EQ(pair.first, 3U);
  EXPECT_EQ(pair.second, 18'000U);
}

TEST(ClosestPair, MinusZeroIsZeroAmongManyToo) {
  std::vector<Point> points = test::SceneMaker(2).box(4000, {1, 1, 1}, {100, 100, 100});
  for (std::size_t i = 0; i < 2000; ++i) points[2000 + i] = points[2 + i % 1000];
  points[0] = {0.0, 0.0, 0.0};
  points[1] = {-0.0, 0.0, -0.0};
  const auto pair = **find_closest_pair(points);
  EXPECT_EQ(pair.first, 0U);
  EXPECT_EQ(pair.second, 1U);
}

// A clump beside open country, and half of the points at one place, where a quadratic cost would
// show.
// Brute force needs 10^10 comparisons here, the search must stay within the test's time.
TEST(Nearest, ClumpsAndDuplicatesStayCheap) {
  constexpr std::size_t kHalf = 50'000;
  test::SceneMaker make(9);
  std::vector<Point> points = make.box(2 * kHalf, {0, 0, 0}, {2e6, 2e6, 2e6});
  for (std::size_t i = 0; i < kHalf; ++i) points[i] = {5, 5, 5};
  const std::vector<Nearest> of_duplicates = *find_nearest_within(points, {1e5});
  EXPECT_EQ(of_duplicates[0].id, 1U);
  EXPECT_EQ(of_duplicates[kHalf - 1].id, 0U);

  const std::vector<Point> clump = make.box(kHalf, {0, 0, 0}, {1, 1, 1});
  std::copy(clump.begin(), clump.end(), points.begin());
  const std::vector<Nearest> nearest = *find_nearest_within(points, {1e5, false, 2});
  for (std::size_t i = 0; i < points.size(); i += 9973) {
    Nearest expected;
    for (PointId j = 0; j < points.size(); ++j) {
      const double apart = distance(points[i], points[j]);
      if (j != i && apart < 1e5 && apart < expected.distance_m) expected = {j, apart};
    }
    EXPECT_EQ(nearest[i].id, expected.id) << i;
    EXPECT_EQ(nearest[i].distance_m, expected.distance_m) << i;
  }
}

TEST(Nearest, EqualsBruteForceOnEveryScene) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    for (const bool inclusive : {false, true}) {
      SCOPED_TRACE(scene.name + (inclusive ? " inclusive" : " strict"));
      const SearchOptions options{scene.threshold_m, inclusive, 2};
      const std::vector<Nearest> expected =
          *brute_force::find_nearest_within(scene.points, options);
      const std::vector<Nearest> found = *find_nearest_within(scene.points, options);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].id, expected[i].id) << i;
        ASSERT_EQ(found[i].distance_m, expected[i].distance_m) << i;
      }
    }
  }
}

TEST(Nearest, NoneWithinTheThresholdIsReported) {
  const std::vector<Nearest> nearest =
      *find_nearest_within(std::vector<Point>{{0, 0, 0}, {10, 0, 0}}, {10.0});
  EXPECT_EQ(nearest[0].id, Nearest::kNone);
  EXPECT_TRUE(std::isinf(nearest[0].distance_m));
}

TEST(Distance, IsThatOfTheDoubles) {
  EXPECT_EQ(distance({0, 0, 0}, {3, 4, 12}), 13.0);
  EXPECT_EQ(distance({1, 1, 1}, {1, 1, 1}), 0.0);
}

}  // namespace
}  // namespace beespace
