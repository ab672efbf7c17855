// Where a live swarm is between its reports.
#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace beespace {
namespace {

using Movers = std::vector<LiveMover>;

void hear(Swarm& swarm, const PositionReport& report) {
  const Status taken = swarm.update(report);
  ASSERT_TRUE(taken.has_value()) << taken.error().message;
}

Swarm swarm_of(const std::vector<PositionReport>& reports) {
  Swarm swarm({.threshold_m = 20.0, .horizon_s = 0.0, .max_age_s = 5.0});
  for (const PositionReport& report : reports) hear(swarm, report);
  return swarm;
}

// Flown on to where `mover` is.
LiveMover flying(AgentId id, const Mover& mover, double heard_s, const Point& heard_at) {
  return {id, mover, heard_s, heard_at, false, true};
}
// Somewhere; last heard of there.
LiveMover unknown(AgentId id, double heard_s, const Point& heard_at, bool stale) {
  return {id, {heard_at, {}}, heard_s, heard_at, stale, false};
}

TEST(SwarmMovers, FlyOnFromTheirLastReports) {
  const Swarm swarm = swarm_of({{8, 1.0, {10, 20, 30}, Velocity{1, -2, 4}},
                                {3, 0.0, {0, 0, 0}},
                                {3, 2.0, {6, 0, -2}},
                                {5, 3.0, {7, 7, 7}, Velocity{}}});
  EXPECT_EQ(swarm.movers(3.0), (Movers{flying(3, {{9, 0, -3}, {3, 0, -1}}, 2.0, {6, 0, -2}),
                                       flying(5, {{7, 7, 7}, {0, 0, 0}}, 3.0, {7, 7, 7}),
                                       flying(8, {{12, 16, 38}, {1, -2, 4}}, 1.0, {10, 20, 30})}));
}

TEST(SwarmMovers, ThatWereHeardOfOnceAreThereAndMarked) {
  Swarm swarm = swarm_of({{3, 0.0, {1, 2, 3}}});
  EXPECT_EQ(swarm.movers(1.0), (Movers{unknown(3, 0.0, {1, 2, 3}, false)}));
  hear(swarm, {3, 1.0, {2, 2, 3}});
  EXPECT_EQ(swarm.movers(2.0), (Movers{flying(3, {{3, 2, 3}, {1, 0, 0}}, 1.0, {2, 2, 3})}));
}

// Until they are removed, however long they are silent.
TEST(SwarmMovers, ThatAreStaleAreNeverForgotten) {
  Swarm swarm = swarm_of({{1, 0.0, {0, 0, 0}, Velocity{3, 0, 0}},
                          {2, 0.0, {50, 0, 0}, Velocity{}},
                          {4, 0.5, {9, 9, 9}}});
  const LiveMover two = flying(2, {{50, 0, 0}, {}}, 6.0, {50, 0, 0});
  const Movers silent = {unknown(1, 0.0, {0, 0, 0}, true), two, unknown(4, 0.5, {9, 9, 9}, true)};
  hear(swarm, {2, 6.0, {50, 0, 0}, Velocity{}});
  ASSERT_TRUE(swarm.advance(6.0).has_value());
  EXPECT_EQ(swarm.movers(6.0), silent);
  for (double now = 10.0; now < 1e6; now *= 2.0) {
    hear(swarm, {2, now, {50, 0, 0}, Velocity{}});
    ASSERT_TRUE(swarm.advance(now).has_value());
    ASSERT_EQ(swarm.movers(now).size(), 3U);
    EXPECT_EQ(swarm.movers(now)[0], silent[0]);
    EXPECT_EQ(swarm.movers(now)[2], silent[2]);
  }
  hear(swarm, {1, 1e6, {1, 0, 0}, Velocity{}});
  EXPECT_EQ(swarm.movers(1e6)[0], flying(1, {{1, 0, 0}, {}}, 1e6, {1, 0, 0}));
  swarm.remove(2);
  swarm.remove(4);
  EXPECT_EQ(swarm.movers(1e6).size(), 1U);
  swarm.remove(1);
  EXPECT_EQ(swarm.movers(1e6), Movers());
}

TEST(SwarmMovers, DoNotExistAtAnInvalidTime) {
  const Swarm swarm = swarm_of({{1, 0.0, {0, 0, 0}, Velocity{1, 0, 0}}});
  EXPECT_EQ(swarm.movers(std::numeric_limits<double>::quiet_NaN()), Movers());
  EXPECT_EQ(swarm.movers(std::numeric_limits<double>::infinity()), Movers());
}

}  // namespace
}  // namespace beespace
