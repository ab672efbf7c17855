// Streams that cross, the funnel and the forest: what makes them what they are.
#include "scenes/missions.hpp"
#include "tests/scenes/mission_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace beespace::scenes {
namespace {

struct Extent {
  Point low{1e300, 1e300, 1e300};
  Point high{-1e300, -1e300, -1e300};
};

template <class Iterator>
Extent extent_of(Iterator begin, Iterator end) {
  Extent extent;
  std::for_each(begin, end, [&extent](const Point& p) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y),
                  std::min(extent.low.z, p.z)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y),
                   std::max(extent.high.z, p.z)};
  });
  return extent;
}

Extent extent_of(const std::vector<Point>& points) {
  return extent_of(points.begin(), points.end());
}

TEST(CrossingStreams, HalfFlyEastAndHalfNorthAndKeepTheirPattern) {
  for (const std::size_t count : {std::size_t{2}, std::size_t{125}, std::size_t{400}}) {
    const Mission mission = crossing_streams(count, 15.0, 5.0, 7);
    const std::size_t east = count - count / 2;
    const double way_m = mission.goals[0].x - mission.starts[0].x;
    EXPECT_GT(way_m, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      const Point& p = mission.starts[i];
      const Point& q = mission.goals[i];
      ASSERT_EQ(q.z, p.z);
      ASSERT_NEAR(q.x - p.x, i < east ? way_m : 0.0, 1e-9);
      ASSERT_NEAR(q.y - p.y, i < east ? 0.0 : way_m, 1e-9);
    }
  }
}

TEST(CrossingStreams, BothGoThroughTheSamePlaceHalfWay) {
  const Mission mission = crossing_streams(500, 15.0, 5.0, 7);
  std::vector<Point> middles;
  for (std::size_t i = 0; i < 500; ++i) {
    const Point& p = mission.starts[i];
    const Point& q = mission.goals[i];
    middles.push_back({0.5 * (p.x + q.x), 0.5 * (p.y + q.y), 0.5 * (p.z + q.z)});
  }
  const Extent east = extent_of(middles.begin(), middles.begin() + 250);
  const Extent north = extent_of(middles.begin() + 250, middles.end());
  // Cubes of seven cells, in the same place but for the stirring.
  for (const Extent& cube : {east, north}) {
    for (const double low : {cube.low.x, cube.low.y, cube.low.z}) EXPECT_NEAR(low, 0.0, 5.0);
  }
  EXPECT_NEAR(east.high.x, 6 * 15.0, 5.0);
  EXPECT_NEAR(north.high.y, 6 * 15.0, 5.0);
}

TEST(Funnel, TheColumnIsFiveTimesNarrowerThanTheField) {
  for (const std::size_t count : {std::size_t{100}, std::size_t{333}, std::size_t{2000}}) {
    const Mission mission = funnel(count, 15.0, 5.0, 7);
    const Extent field = extent_of(mission.starts);
    const Extent column = extent_of(mission.goals);
    const double wide_m = field.high.y - field.low.y;
    EXPECT_LE(5.0 * (column.high.y - column.low.y), wide_m);
    EXPECT_LE(5.0 * (column.high.z - column.low.z), wide_m);
    // Around the same axis, and well behind.
    EXPECT_NEAR(column.low.y + column.high.y, field.low.y + field.high.y, 15.0);
    EXPECT_GE(column.low.x - field.high.x, 0.9 * wide_m);
    EXPECT_LE(field.high.x - field.low.x, 15.0 + 10.0);
  }
}

TEST(Funnel, InTheColumnTheyAreCloserTogetherButNotTooClose) {
  for (const auto& [spacing_m, expected_m] :
       {std::pair{15.0, 10.0}, std::pair{8.0, 8.0}, std::pair{5.0, 5.0}}) {
    EXPECT_NEAR(least_distance(funnel(333, spacing_m, 5.0, 7).goals), expected_m, 1e-9);
  }
}

TEST(Funnel, TheNearestBeesFlyInTheFarthest) {
  const Mission mission = funnel(333, 15.0, 5.0, 7);
  const Extent field = extent_of(mission.starts);
  const Extent column = extent_of(mission.goals);
  const Point mouth{column.low.x, 0.5 * (column.low.y + column.high.y),
                    0.5 * (column.low.z + column.high.z)};
  std::vector<std::size_t> order(333);
  for (std::size_t i = 0; i < 333; ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return mission.goals[a].x > mission.goals[b].x; });
  // From slice to slice of the column, no bee is nearer than those before. The mouth is not exactly
  // where the mission has it.
  double farthest_m = 0.0;
  for (const std::size_t i : order) {
    const double to_mouth_m = distance(mission.starts[i], mouth);
    EXPECT_GE(to_mouth_m, farthest_m - 0.15 * (field.high.y - field.low.y));
    farthest_m = std::max(farthest_m, to_mouth_m);
  }
}

// Of the surface of what a forest has.
double distance_to(const Obstacle& obstacle, const Point& p) {
  if (const auto* pillar = std::get_if<UprightCylinder>(&obstacle)) {
    EXPECT_EQ(pillar->heights.low_m, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(pillar->heights.high_m, std::numeric_limits<double>::infinity());
    return std::hypot(p.x - pillar->x, p.y - pillar->y) - pillar->radius_m;
  }
  return p.z - std::get<Ground>(obstacle).height_m;
}

TEST(Pillars, NoBeeStartsOrStopsNearAnObstacle) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{30}, std::size_t{700}}) {
    for (const double spacing_m : {5.0, 15.0}) {
      const Mission mission = pillars(count, spacing_m, 5.0, 7);
      for (const Obstacle& obstacle : mission.obstacles) {
        for (const Point& p : mission.starts) ASSERT_GE(distance_to(obstacle, p), 2 * spacing_m);
        for (const Point& p : mission.goals) ASSERT_GE(distance_to(obstacle, p), 2 * spacing_m);
      }
    }
  }
}

TEST(Pillars, BetweenAnyTwoIsRoomForSeveralBees) {
  const Mission mission = pillars(700, 10.0, 5.0, 7);
  std::vector<UprightCylinder> forest;
  for (const Obstacle& obstacle : mission.obstacles) {
    if (std::holds_alternative<UprightCylinder>(obstacle)) {
      forest.push_back(std::get<UprightCylinder>(obstacle));
    }
  }
  EXPECT_EQ(forest.size() + 1, mission.obstacles.size());  // and the ground
  EXPECT_GE(forest.size(), 9u);
  for (std::size_t i = 0; i < forest.size(); ++i) {
    EXPECT_EQ(forest[i].radius_m, 10.0);
    for (std::size_t j = i + 1; j < forest.size(); ++j) {
      const double apart_m = std::hypot(forest[i].x - forest[j].x, forest[i].y - forest[j].y);
      EXPECT_GE(apart_m - 20.0, 3 * 10.0 - 1e-9);
    }
  }
}

TEST(Pillars, TheForestStandsBetweenStartsAndGoals) {
  const Mission mission = pillars(700, 15.0, 5.0, 7);
  const Extent before = extent_of(mission.starts);
  const Extent behind = extent_of(mission.goals);
  Extent forest;
  std::size_t blocked = 0;
  for (const Obstacle& obstacle : mission.obstacles) {
    const auto* pillar = std::get_if<UprightCylinder>(&obstacle);
    if (pillar == nullptr) continue;
    EXPECT_GT(pillar->x, before.high.x);
    EXPECT_LT(pillar->x, behind.low.x);
    forest.low.y = std::min(forest.low.y, pillar->y);
    forest.high.y = std::max(forest.high.y, pillar->y);
  }
  // Also at the sides.
  EXPECT_LT(forest.low.y, before.low.y);
  EXPECT_GT(forest.high.y, before.high.y);
  for (std::size_t i = 0; i < 700; ++i) {
    const Point& p = mission.starts[i];
    const Point& q = mission.goals[i];
    bool straight_on = true;
    for (int step = 0; step <= 1000 && straight_on; ++step) {
      const double share = 0.001 * step;
      const Point at{p.x + share * (q.x - p.x), p.y + share * (q.y - p.y),
                     p.z + share * (q.z - p.z)};
      straight_on =
          std::none_of(mission.obstacles.begin(), mission.obstacles.end(),
                       [&](const Obstacle& obstacle) { return distance_to(obstacle, at) < 0.0; });
    }
    if (!straight_on) ++blocked;
  }
  EXPECT_GT(blocked, 350u);  // most must go around something
}

TEST(Pillars, GoalsAreAPermutationOfPlacesOnTheOtherSide) {
  const Mission mission = pillars(100, 15.0, 5.0, 7);
  const double depth_m = extent_of(mission.starts).low.x + extent_of(mission.goals).high.x;
  std::vector<Point> mirrored;
  for (const Point& p : mission.starts) mirrored.push_back({depth_m - p.x, p.y, p.z});
  const auto goals = sorted(mission.goals);
  const auto expected = sorted(mirrored);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_LT(distance(goals[i], expected[i]), 1e-9);
}

}  // namespace
}  // namespace beespace::scenes
