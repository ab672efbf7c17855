// Wide swarms, of which most points are left out before the search: answers as by brute force,
// exactly at the threshold and one ulp either side.
#include "search/candidates.hpp"

#include "tests/support/own_resources.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/search_scenes.hpp"

#include <beespace/beespace.hpp>
#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace beespace {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

std::optional<search::Candidates> candidates_of(const std::vector<Point>& points,
                                                test::OwnResources& own) {
  const search::SearchDomain domain = *search::SearchDomain::of(points, own.with);
  return search::Candidates::of(domain, 1.0, own.with, {});
}

std::vector<Point> radii(test::SceneMaker& make, std::size_t size) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < size; ++i) {
    const double radius = std::pow(10.0, make.between(-9.0, 9.0));
    points.push_back(
        {radius * make.between(-1, 1), radius * make.between(-1, 1), radius * make.between(-1, 1)});
  }
  return points;
}

std::vector<Point> nested_clumps(test::SceneMaker& make, std::size_t size) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < size; ++i) {
    const double side = std::pow(10.0, 9.0 - static_cast<double>(i % 20));
    points.push_back({make.between(0, side), make.between(0, side), make.between(0, side)});
  }
  return points;
}

std::vector<Point> powers_of_two(test::SceneMaker& make, std::size_t size) {
  const auto power = [&] {
    return std::ldexp(make.below(2) == 0 ? -1.0 : 1.0, static_cast<int>(make.below(201)) - 100);
  };
  std::vector<Point> points;
  for (std::size_t i = 0; i < size; ++i) points.push_back({power(), power(), power()});
  return points;
}

// A swarm with some outliers, which alone make it wide.
std::vector<Point> outliers(test::SceneMaker& make, std::size_t size) {
  std::vector<Point> points = make.box(size, {0, 0, 0}, {20, 20, 20});
  for (std::size_t i = 0; i < size / 50; ++i) {
    points.push_back({make.between(-1e12, 1e12), make.between(-1e9, 1e9), make.between(-1e3, 1e3)});
  }
  return points;
}

// Adds points at a distance of 1 from some others, and of one ulp more and less.
std::vector<Point> with_ties(std::vector<Point> points) {
  const std::size_t size = points.size();
  for (std::size_t i = 0; i < size; i += 7) {
    const double x = points[i].x + 1.0;
    if (x == 0.0) continue;  // an ulp from there is outside the domain of coordinates
    for (const double tie : {x, std::nextafter(x, kUnbounded), std::nextafter(x, -kUnbounded)}) {
      points.push_back({tie, points[i].y, points[i].z});
    }
  }
  return points;
}

void expect_brute_force_answers(const std::vector<Point>& points) {
  for (const bool inclusive : {false, true}) {
    SearchOptions options{1.0};
    options.inclusive = inclusive;
    const auto at_risk = *brute_force::find_at_risk(points, options);
    const auto counts = *brute_force::count_neighbors(points, options);
    const IdRows truly = *brute_force::find_conflict_groups(points, options);
    for (const unsigned threads : {1U, 3U}) {
      options.threads = threads;
      SCOPED_TRACE(std::string(inclusive ? "inclusive, " : "") + std::to_string(threads));
      EXPECT_EQ(*find_at_risk(points, options), at_risk);
      EXPECT_EQ(*count_neighbors(points, options), counts);
      const IdRows groups = *find_conflict_groups(points, options);
      EXPECT_EQ(groups.offsets, truly.offsets);
      EXPECT_EQ(groups.ids, truly.ids);
    }
  }
}

TEST(Candidates, GiveTheAnswersOfBruteForce) {
  for (std::uint32_t seed = 0; seed < (test::kSanitized ? 2 : 4); ++seed) {
    test::SceneMaker make(seed);
    const std::size_t size = 300 + 400 * seed;
    for (const auto& scene :
         {radii(make, size), nested_clumps(make, size), powers_of_two(make, size),
          outliers(make, size), make.box(size, {-1e9, 0, 0}, {1e9, 1e9, 10})}) {
      expect_brute_force_answers(with_ties(scene));
    }
  }
}

TEST(Candidates, AreNoneWhereAllAreFarApart) {
  test::SceneMaker make(1);
  const std::vector<Point> points = make.box(500, {0, 0, 0}, {1e9, 1e9, 1e9});
  test::OwnResources own;
  const auto left = candidates_of(points, own);
  ASSERT_TRUE(left);
  EXPECT_LE(left->size(), 4U);  // tables of hashes are seldom wrong, and never twice alike
  expect_brute_force_answers(points);
}

TEST(Candidates, KeepWhatIsNearAcrossAllScales) {
  test::SceneMaker make(2);
  std::vector<Point> points = radii(make, 20'000);
  const std::vector<Point> alone = make.box(20'000, {-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9});
  points.insert(points.end(), alone.begin(), alone.end());
  test::OwnResources own;
  const auto left = candidates_of(points, own);
  ASSERT_TRUE(left);
  // Half of the former are within 1 m of the middle; some of those within a hundred have company.
  EXPECT_GT(left->size(), 10'000U);
  EXPECT_LT(left->size(), 16'000U);
}

// A copy of nearly all of them would take more memory than it spares.
TEST(Candidates, AreNoneWhereMostAreLeft) {
  test::SceneMaker make(3);
  const std::vector<Point> points = outliers(make, 5'000);
  test::OwnResources own;
  EXPECT_FALSE(candidates_of(points, own));
  if (!test::kSanitized) expect_brute_force_answers(points);
}

TEST(Candidates, AreNotLookedForWhereNoAxisIsLong) {
  test::SceneMaker make(4);
  test::OwnResources own;
  EXPECT_FALSE(candidates_of(make.box(500, {0, 0, 0}, {1e5, 1e5, 1e5}), own));
}

TEST(Candidates, AreNotLookedForWhereAllHaveCompany) {
  test::SceneMaker make(5);
  std::vector<Point> points = make.box(500, {0, 0, 0}, {1e9, 1e9, 1e9});
  for (std::size_t i = 0; i < 500; ++i) points.push_back(points[i]);
  test::OwnResources own;
  EXPECT_FALSE(candidates_of(points, own));
}

}  // namespace
}  // namespace beespace
