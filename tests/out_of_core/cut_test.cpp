// Each point has one home, and is in the halo of each cell that has a point within reach.
#include "out_of_core/cut.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace beespace::out_of_core {
namespace {

struct Where {
  CellNumber home = 0;
  std::set<CellNumber> all;
};

Where where(const Cut& cut, const Point& point) {
  Where found;
  int homes = 0;
  cut.for_each_cell(point, [&](CellNumber cell, bool home) {
    EXPECT_LT(cell, cut.cells());
    EXPECT_TRUE(found.all.insert(cell).second) << "told twice";
    if (home) {
      found.home = cell;
      ++homes;
    }
  });
  EXPECT_EQ(homes, 1);
  return found;
}

bool within(const Point& a, const Point& b, const Reach& reach) {
  return std::abs(a.x - b.x) <= reach[0] && std::abs(a.y - b.y) <= reach[1] &&
         std::abs(a.z - b.z) <= reach[2];
}

// Those of blocks are those of points.
void expect_homes(const std::vector<Point>& points, const Cut& cut,
                  const std::vector<Where>& places) {
  core::PointBlock block;
  Cut::Homes homes;
  core::for_each_block(0, points.size(), [&](std::size_t begin, std::size_t count) {
    block.load(points, begin, count);
    cut.find_homes(block, count, homes);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(homes.cell[i], places[begin + i].home) << begin + i;
      ASSERT_EQ(homes.near_border[i], places[begin + i].all.size() > 1) << begin + i;
    }
  });
}

void expect_complete_halos(const std::vector<Point>& points, const Cut& cut, const Reach& reach) {
  std::vector<Where> places;
  for (const Point& point : points) places.push_back(where(cut, point));
  expect_homes(points, cut, places);
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < points.size(); ++b) {
      if (!within(points[a], points[b], reach)) continue;
      ASSERT_TRUE(places[b].all.contains(places[a].home)) << a << " and " << b;
    }
  }
}

std::vector<Point> uniform(std::size_t count, double side, double offset = 0.0) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(offset, offset + side);
  std::vector<Point> points(count);
  for (Point& point : points) point = {place(random), place(random), place(random)};
  return points;
}

std::size_t fullest_home(const std::vector<Point>& points, const Cut& cut) {
  std::vector<std::size_t> counts(cut.cells());
  for (const Point& point : points) ++counts[where(cut, point).home];
  return *std::max_element(counts.begin(), counts.end());
}

TEST(Cut, WithoutASampleAllOfSpaceIsOneCell) {
  const Cut cut;
  EXPECT_EQ(cut.cells(), 1U);
  EXPECT_EQ(where(cut, {1e100, -3, 0}).home, 0U);
  std::vector<Point> none;
  EXPECT_EQ(Cut::of_sample(none, 10, {1, 1, 1}).cells(), 1U);
}

TEST(Cut, CellsOfUniformPointsHaveAtMostSoMany) {
  auto points = uniform(4000, 100.0);
  auto sample = points;
  const Reach reach = {2.0, 2.0, 2.0};
  const Cut cut = Cut::of_sample(sample, 300, reach);
  EXPECT_GE(cut.cells(), 14U);
  EXPECT_LE(cut.cells(), 60U);
  EXPECT_LE(fullest_home(points, cut), 300U);
  expect_complete_halos(points, cut, reach);
}

// Where the reach is a few ulps, v + reach is rounded.
TEST(Cut, HalosAreCompleteWhereCoordinatesAreCoarse) {
  for (const double offset : {0x1p52, -0x1p52, 0x1p300}) {
    const double ulp = std::nextafter(std::abs(offset), std::numeric_limits<double>::infinity()) -
                       std::abs(offset);
    auto points = uniform(1000, 200.0 * ulp, offset);
    auto sample = points;
    const Reach reach = {1.5 * ulp, 1.0 * ulp, 2.5 * ulp};
    const Cut cut = Cut::of_sample(sample, 50, reach);
    EXPECT_GT(cut.cells(), 5U);
    expect_complete_halos(points, cut, reach);
  }
}

// On both sides of each plane there are points just within reach of it.
TEST(Cut, HalosReachToTheEnd) {
  constexpr double kStep = 0x1p-10;
  const Reach reach = {1.0, 1.0, 1.0};
  std::vector<Point> sample;
  for (int index = 0; index < 20'000; ++index) sample.push_back({index * kStep, 0, 0});
  const auto points = sample;
  const Cut cut = Cut::of_sample(sample, 3000, reach);
  EXPECT_GE(cut.cells(), 4U);
  for (const Point& point : points) {
    const CellNumber home = where(cut, point).home;
    ASSERT_TRUE(where(cut, {point.x + 1.0, 0, 0}).all.contains(home)) << point.x;
    ASSERT_TRUE(where(cut, {point.x - 1.0, 0, 0}).all.contains(home)) << point.x;
  }
}

TEST(Cut, APointOnAPlaneBelongsToOneSide) {
  std::vector<Point> points;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y) points.push_back({1.0 * x, 1.0 * y, 0.0});
  }
  auto sample = points;
  const Reach reach = {1.0, 1.0, 1.0};
  const Cut cut = Cut::of_sample(sample, 200, reach);
  EXPECT_GE(cut.cells(), 8U);
  expect_complete_halos(points, cut, reach);
}

TEST(Cut, ACrowdStaysWholeAndTheRestIsCutOff) {
  auto points = uniform(1000, 1000.0);
  auto crowd = uniform(3000, 0.5, 400.0);
  points.insert(points.end(), crowd.begin(), crowd.end());
  auto sample = points;
  const Reach reach = {10.0, 10.0, 10.0};
  const Cut cut = Cut::of_sample(sample, 500, reach);
  expect_complete_halos(points, cut, reach);
  std::size_t told = 0;
  for (const Point& point : points) told += where(cut, point).all.size();
  // Each plane through the crowd would double it.
  EXPECT_LT(told, points.size() * 3 / 2);
  std::set<CellNumber> homes;
  for (const Point& point : crowd) homes.insert(where(cut, point).home);
  EXPECT_EQ(homes.size(), 1U);
}

TEST(Cut, OnePlaceCannotBeCut) {
  std::vector<Point> sample(1000, {5, 5, 5});
  EXPECT_EQ(Cut::of_sample(sample, 10, {1, 1, 1}).cells(), 1U);
}

}  // namespace
}  // namespace beespace::out_of_core
