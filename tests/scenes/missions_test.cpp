#include "scenes/missions.hpp"

#include "tests/scenes/mission_checks.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace beespace::scenes {
namespace {

using Make = Mission (*)(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed);

constexpr Make kAll[] = {random_swap, antipodal_swap, crossing_streams, funnel, pillars};
constexpr std::size_t kCounts[] = {0, 1, 2, 3, 5, 7, 8, 9, 20, 27, 28, 100, 333};

TEST(Missions, StartsAndGoalsAreClearOfEachOther) {
  for (const Make make : kAll) {
    for (const std::size_t count : kCounts) {
      for (const double spacing_m : {5.0, 5.5, 15.0}) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
          SCOPED_TRACE(testing::Message() << count << " bees, " << spacing_m << " m apart");
          ASSERT_NO_FATAL_FAILURE(expect_clear(make(count, spacing_m, 5.0, seed), count, 5.0));
        }
      }
    }
  }
}

TEST(Missions, ARandomSwapIsAPermutationOfPlaces) {
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
  for (const Make make : kAll) {
    EXPECT_EQ(fingerprint(make(100, 15.0, 5.0, 1)), fingerprint(make(100, 15.0, 5.0, 1)));
    EXPECT_NE(fingerprint(make(100, 15.0, 5.0, 1)), fingerprint(make(100, 15.0, 5.0, 2)));
  }
}

// Not for the sphere: sines and cosines of standard libraries differ in their last bits.
TEST(Missions, TheOthersHaveTheseBitsOnEveryMachine) {
  EXPECT_EQ(fingerprint(random_swap(500, 15.0, 5.0, 1)), 14'404'843'168'588'355'565u);
  EXPECT_EQ(fingerprint(crossing_streams(500, 15.0, 5.0, 1)), 1'220'574'774'855'663'755u);
  EXPECT_EQ(fingerprint(funnel(500, 15.0, 5.0, 1)), 7'388'912'607'765'380'433u);
  EXPECT_EQ(fingerprint(pillars(500, 15.0, 5.0, 1)), 16'639'880'182'003'151'589u);
}

}  // namespace
}  // namespace beespace::scenes
