#include "scenes/missions.hpp"

#include "tests/scenes/fingerprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace beespace::scenes {
namespace {

std::uint64_t fingerprint(const Mission& mission) {
  Fingerprint fingerprint;
  for (const std::vector<Point>* points : {&mission.starts, &mission.goals}) {
    for (const auto& [x, y, z] : *points) fingerprint.take({x, y, z});
  }
  return fingerprint.value();
}

double distance(const Point& p, const Point& q) {
  return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
}

double least_distance(const std::vector<Point>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      least = std::min(least, distance(points[i], points[j]));
    }
  }
  return least;
}

std::vector<Point> sorted(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  return points;
}

void expect_clear(const Mission& mission, std::size_t count, double clear_m) {
  ASSERT_EQ(mission.starts.size(), count);
  ASSERT_EQ(mission.goals.size(), count);
  if (count < 2) return;
  ASSERT_GE(least_distance(mission.starts), clear_m);
  ASSERT_GE(least_distance(mission.goals), clear_m);
}

constexpr std::size_t kCounts[] = {0, 1, 2, 3, 5, 7, 8, 9, 20, 27, 28, 100, 333};

TEST(Missions, StartsAndGoalsAreClearOfEachOther) {
  for (const std::size_t count : kCounts) {
    for (const double spacing_m : {5.0, 5.5, 15.0}) {
      for (const std::uint64_t seed : {1U, 2U, 3U}) {
        SCOPED_TRACE(testing::Message() << count << " bees, " << spacing_m << " m apart");
        ASSERT_NO_FATAL_FAILURE(expect_clear(random_swap(count, spacing_m, 5.0, seed), count, 5.0));
        ASSERT_NO_FATAL_FAILURE(
            expect_clear(antipodal_swap(count, spacing_m, 5.0, seed), count, 5.0));
      }
    }
  }
}

TEST(Missions, InARandomSwapEverybodyTakesSomebodysPlace) {
  const Mission mission = random_swap(500, 15.0, 5.0, 7);
  EXPECT_EQ(sorted(mission.goals), sorted(mission.starts));
  std::size_t stay = 0;
  for (std::size_t i = 0; i < 500; ++i) stay += mission.goals[i] == mission.starts[i] ? 1U : 0U;
  EXPECT_LT(stay, 6U);  // about one does, by chance
  for (const auto& [x, y, z] : mission.starts) {
    for (const double number : {x, y, z}) ASSERT_TRUE(number > -5.0 && number < 7 * 15.0 + 5.0);
  }
}

TEST(Missions, InAnAntipodalSwapAllWaysLeadThroughTheMiddle) {
  const Mission mission = antipodal_swap(200, 15.0, 5.0, 7);
  const double radius_m = distance(mission.starts[0], {});
  // About as large as it must be for the spacing.
  EXPECT_GE(least_distance(mission.starts), 15.0);
  EXPECT_LT(least_distance(mission.starts), 1.2 * 15.0);
  for (std::size_t i = 0; i < 200; ++i) {
    const Point& p = mission.starts[i];
    ASSERT_NEAR(distance(p, {}), radius_m, 1e-9);
    ASSERT_EQ(mission.goals[i], (Point{-p.x, -p.y, -p.z}));
  }
}

TEST(Missions, HeadOnAreTwoOnOneLine) {
  const Mission mission = head_on(80.0);
  EXPECT_EQ(mission.starts, (std::vector<Point>{{0, 0, 0}, {80, 0, 0}}));
  EXPECT_EQ(mission.goals, (std::vector<Point>{{80, 0, 0}, {0, 0, 0}}));
}

TEST(Missions, TheSameSeedGivesTheSameAndAnotherAnother) {
  EXPECT_EQ(fingerprint(random_swap(100, 15.0, 5.0, 1)),
            fingerprint(random_swap(100, 15.0, 5.0, 1)));
  EXPECT_NE(fingerprint(random_swap(100, 15.0, 5.0, 1)),
            fingerprint(random_swap(100, 15.0, 5.0, 2)));
  EXPECT_EQ(fingerprint(antipodal_swap(100, 15.0, 5.0, 1)),
            fingerprint(antipodal_swap(100, 15.0, 5.0, 1)));
  EXPECT_NE(fingerprint(antipodal_swap(100, 15.0, 5.0, 1)),
            fingerprint(antipodal_swap(100, 15.0, 5.0, 2)));
}

// Of the sphere not: sines and cosines of standard libraries differ in their last bits.
TEST(Missions, ARandomSwapHasTheseBitsOnEveryMachine) {
  EXPECT_EQ(fingerprint(random_swap(500, 15.0, 5.0, 1)), 14'404'843'168'588'355'565u);
}

}  // namespace
}  // namespace beespace::scenes
