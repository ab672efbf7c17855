// What a swarm keeps: no more than it needs, however many reports it gets.
#include "motion/live/live_bees.hpp"

#include "motion/live/live_encounters.hpp"
#include "tests/support/own_resources.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/swarm_replay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace beespace::motion {
namespace {

Separation closer_than(double threshold_m) {
  return {threshold_m};
}

std::size_t most_fixes(const LiveBees& bees) {
  std::size_t most = 0;
  for (const LiveSegment& segment : bees.segments()) most = std::max(most, segment.fixes.size());
  return most;
}

// 20 bees, 1000 reports each; one of them is heard only every eighth time.
TEST(LiveBees, KeepNoMoreThanSinceTheOldestLastReport) {
  const auto tracks = scenes::random_turns(20, {100, 100, 30}, {3, 12}, {1000.0, 1.0, true}, 3);
  test::OwnResources own;
  LiveBees bees(false);
  const WalkSeparation separation{closer_than(22.0), closer_than(20.0), false};
  LiveEncounters encounters(separation, 2.0);
  std::vector<SwarmEvent> events;
  const std::size_t reports = test::kSanitized ? 100 : 1000;
  for (std::size_t i = 0; i < reports; ++i) {
    for (AgentId id = 0; id < tracks.size(); ++id) {
      if (id == 7 && i % 8 != 0) continue;
      const auto& [time, position] = tracks[id].fixes[i];
      ASSERT_EQ(bees.take({id, time, position}, 100.0), LiveBees::Taken::kYes);
    }
    own.memory.start_call();
    encounters.search(bees, own.with, events);
    ASSERT_LE(most_fixes(bees), 11U) << "after " << i << " s";
    ASSERT_EQ(bees.segments().size(), tracks.size());
  }
  EXPECT_GT(events.size(), reports / 5);
}

// Every few seconds one bee disappears for ever, and another one appears.
TEST(LiveBees, GiveTheirPlacesToLaterBees) {
  test::OwnResources own;
  LiveBees bees(true);
  const WalkSeparation separation{closer_than(22.0), closer_than(20.0), false};
  LiveEncounters encounters(separation, 2.0);
  std::vector<SwarmEvent> events;
  for (PointId i = 0; i < 2000; ++i) {
    const double time = 0.5 * i;
    bees.take({i, time, {1.0 * (i % 7), 0, 0}}, 100.0);
    if (i > 0) bees.take({i - 1, time, {1.0 * (i % 5), 1, 0}}, 100.0);
    if (i > 1) bees.remove(i - 2);
    own.memory.start_call();
    bees.settle(time, 100.0);
    encounters.search(bees, own.with, events);
    ASSERT_LE(bees.segments().size(), 5U);
    ASSERT_LE(bees.under_way(), 2U);
  }
}

TEST(LiveBees, KeepTheLastTwoReportsForTheVelocity) {
  LiveBees bees(false);
  std::pmr::vector<std::uint32_t> dropped;
  for (int i = 0; i < 5; ++i) {
    bees.take({1, 1.0 * i, {2.0 * i, 0, 0}}, 100.0);
    bees.forget(dropped);
  }
  ASSERT_EQ(bees.segments()[0].fixes.size(), 2U);
  const auto now = bees.segments()[0].at(5.0);
  ASSERT_TRUE(now.has_value());
  EXPECT_EQ(now->mover, (Mover{{10, 0, 0}, {2, 0, 0}}));
}

TEST(LiveBees, AreOneBeeAgainOnlyWithinTheGreatestAge) {
  using Taken = LiveBees::Taken;
  LiveBees bees(false);
  EXPECT_EQ(bees.take({1, 0.0, {0, 0, 0}}, 5.0), Taken::kYes);
  EXPECT_EQ(bees.take({1, 5.0, {1, 0, 0}}, 5.0), Taken::kYes);
  EXPECT_EQ(bees.segments()[0].fixes.size(), 2U);
  EXPECT_EQ(bees.take({1, 5.0, {1, 0, 0}}, 5.0), Taken::kRepeated);
  EXPECT_EQ(bees.take({1, 5.0, {2, 0, 0}}, 5.0), Taken::kContrary);
  EXPECT_EQ(bees.take({1, 0.0, {0, 0, 0}}, 5.0), Taken::kRepeated);
  EXPECT_EQ(bees.take({1, 0.0, {9, 0, 0}}, 5.0), Taken::kContrary);
  EXPECT_EQ(bees.take({1, 4.0, {1, 0, 0}}, 5.0), Taken::kLate);
  EXPECT_EQ(bees.take({1, 10.5, {1, 0, 0}}, 5.0), Taken::kYes);
  ASSERT_EQ(bees.segments().size(), 2U);
  EXPECT_TRUE(bees.segments()[0].complete);
  EXPECT_EQ(bees.segments()[1].fixes.size(), 1U);
}

}  // namespace
}  // namespace beespace::motion
