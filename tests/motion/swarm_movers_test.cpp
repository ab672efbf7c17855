// Where a live swarm is between its reports.
#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace beespace {
namespace {

using Movers = std::vector<LiveMover>;

void hear(Swarm& swarm, const Report& report) {
  const Status taken = swarm.update(report);
  ASSERT_TRUE(taken.has_value()) << taken.error().message;
}

Swarm swarm_of(const std::vector<Report>& reports) {
  Swarm swarm({.threshold_m = 20.0, .horizon_s = 0.0, .max_age_s = 5.0});
  for (const Report& report : reports) hear(swarm, report);
  return swarm;
}

TEST(SwarmMovers, FlyOnFromTheirLastReports) {
  const Swarm swarm = swarm_of({{8, 1.0, {10, 20, 30}, Velocity{1, -2, 4}},
                                {3, 0.0, {0, 0, 0}},
                                {3, 2.0, {6, 0, -2}},
                                {5, 3.0, {7, 7, 7}, Velocity{}}});
  EXPECT_EQ(swarm.movers(3.0), (Movers{{3, {{9, 0, -3}, {3, 0, -1}}},
                                       {5, {{7, 7, 7}, {0, 0, 0}}},
                                       {8, {{12, 16, 38}, {1, -2, 4}}}}));
}

TEST(SwarmMovers, AreThoseWhoseVelocityIsKnown) {
  Swarm swarm = swarm_of({{3, 0.0, {0, 0, 0}}});
  EXPECT_EQ(swarm.movers(1.0), Movers());
  hear(swarm, {3, 1.0, {2, 0, 0}});
  EXPECT_EQ(swarm.movers(1.0), (Movers{{3, {{2, 0, 0}, {2, 0, 0}}}}));
}

TEST(SwarmMovers, AreNotStaleNorRemovedAndMayComeBack) {
  Swarm swarm = swarm_of({{1, 0.0, {0, 0, 0}, Velocity{}}, {2, 0.0, {50, 0, 0}, Velocity{}}});
  hear(swarm, {2, 6.0, {50, 0, 0}, Velocity{}});
  ASSERT_TRUE(swarm.advance(6.0).has_value());
  EXPECT_EQ(swarm.movers(6.0), (Movers{{2, {{50, 0, 0}, {}}}}));
  hear(swarm, {1, 6.5, {1, 0, 0}, Velocity{}});
  EXPECT_EQ(swarm.movers(6.5), (Movers{{1, {{1, 0, 0}, {}}}, {2, {{50, 0, 0}, {}}}}));
  swarm.remove(2);
  EXPECT_EQ(swarm.movers(6.5), (Movers{{1, {{1, 0, 0}, {}}}}));
}

TEST(SwarmMovers, AreNowhereAtNoTime) {
  const Swarm swarm = swarm_of({{1, 0.0, {0, 0, 0}, Velocity{1, 0, 0}}});
  EXPECT_EQ(swarm.movers(std::numeric_limits<double>::quiet_NaN()), Movers());
  EXPECT_EQ(swarm.movers(std::numeric_limits<double>::infinity()), Movers());
}

}  // namespace
}  // namespace beespace
