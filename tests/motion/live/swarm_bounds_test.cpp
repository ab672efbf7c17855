// A live swarm with more bees or pairs than its bounds reports that, and keeps the closest pairs.
#include "tests/support/conflict_printer.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/swarm_replay.hpp"

#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using test::Events;

Events overloads(const Events& events, SwarmBound bound) {
  Events some;
  for (const SwarmEvent& event : events) {
    if (event.kind == EventKind::kOverloaded && event.bound == bound) some.push_back(event);
  }
  return some;
}

TEST(SwarmBounds, OfBeesRefuseTheNextOneAndSaySo) {
  SwarmOptions options{.threshold_m = 20.0};
  options.max_agents = 2;
  Swarm swarm(options);
  EXPECT_TRUE(swarm.update({1, 0.0, {0, 0, 0}}).has_value());
  EXPECT_TRUE(swarm.update({2, 0.0, {90, 0, 0}}).has_value());
  for (const AgentId id : {7U, 8U, 7U}) {
    const Status refused = swarm.update({id, 0.5, {50, 0, 0}});
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::kTooManyPoints);
    EXPECT_EQ(refused.error().location.record, id);
  }
  EXPECT_TRUE(swarm.update({1, 1.0, {0, 0, 0}}).has_value()) << "the others go on";
  Events events;
  test::take_all(swarm, 1.0, events);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::kOverloaded);
  EXPECT_EQ(events[0].bound, SwarmBound::kAgents);
  EXPECT_EQ(events[0].first, 7U);
  EXPECT_EQ(events[0].count, 3U);
  EXPECT_EQ(swarm.counts().refused, 3U);
  EXPECT_EQ(swarm.counts().agents, 2U);
  events.clear();
  test::take_all(swarm, 20.0, events);
  EXPECT_TRUE(overloads(events, SwarmBound::kAgents).empty());
  EXPECT_FALSE(swarm.update({7, 20.0, {50, 0, 0}}).has_value()) << "stale ones are not forgotten";
  swarm.remove(2);
  EXPECT_TRUE(swarm.update({7, 20.0, {50, 0, 0}}).has_value());
}

// Bees on a line, with growing distances: of the pairs within 20 m the closest are kept.
TEST(SwarmBounds, OfPairsKeepTheClosest) {
  for (const unsigned threads : {1U, 3U}) {
    SwarmOptions options{.threshold_m = 20.0};
    options.max_pairs = 10;
    options.horizon_s = 0.0;
    options.threads = threads;
    Swarm swarm(options);
    std::vector<double> x = {0.0};
    for (int i = 1; i < 30; ++i) x.push_back(x.back() + 1.0 + 0.01 * i);
    Events events;
    for (const double time_s : {0.0, 1.0}) {
      for (AgentId id = 0; id < x.size(); ++id) {
        ASSERT_TRUE(swarm.update({id, time_s, {x[id], 0, 0}}).has_value());
      }
      test::take_all(swarm, time_s, events);
    }
    const Events entered = test::of_kind(events, EventKind::kEntered);
    ASSERT_EQ(entered.size(), 10U);
    for (const SwarmEvent& event : entered) {
      EXPECT_EQ(event.second, event.first + 1);
      EXPECT_LE(event.second, 10U);
    }
    const Events left_out = overloads(events, SwarmBound::kPairs);
    ASSERT_EQ(left_out.size(), 2U) << "as long as it lasts";
    EXPECT_GT(left_out[0].count, 100U);
    EXPECT_NEAR(left_out[0].distance_m, 1.11, 1e-9);
    EXPECT_EQ(test::of_kind(events, EventKind::kLost).size(), 0U);
  }
}

// A followed pair makes room for one that is clearly closer: it is reported as lost, not forgotten.
TEST(SwarmBounds, OfPairsMakeRoomForCloserOnes) {
  SwarmOptions options{.threshold_m = 20.0};
  options.max_pairs = 1;
  options.horizon_s = 0.0;
  Swarm swarm(options);
  Events events;
  for (int i = 0; i <= 10; ++i) {
    for (const auto& [id, x] : std::vector<std::pair<AgentId, double>>{
             {1, 0.0},
             {2, 10.0},
             {3, 500.0},
             {4, 560.0 - 10.0 * i + (i > 5 ? 10.0 * (i - 5) : 0.0) - 9.0}}) {
      ASSERT_TRUE(swarm.update({id, 1.0 * i, {x, 0, 0}}).has_value());
    }
    test::take_all(swarm, i, events);
  }
  const Events entered = test::of_kind(events, EventKind::kEntered);
  ASSERT_EQ(entered.size(), 2U);
  EXPECT_EQ(entered[0].first, 1U);
  EXPECT_EQ(entered[1].first, 3U);
  const Events lost = test::of_kind(events, EventKind::kLost);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].first, 1U);
  EXPECT_FALSE(overloads(events, SwarmBound::kPairs).empty());
}

// Each entered has one end, whatever is dropped, and the followed pairs are true.
TEST(SwarmBounds, LeaveEachEncounterOneEnd) {
  const auto tracks = scenes::random_turns(40, {60, 60, 20}, {3, 12}, {12.0, 1.0, false}, 4);
  SwarmOptions options{.threshold_m = 12.0};
  options.max_pairs = 20;
  Swarm swarm(options);
  Events events;
  double last_s = 0.0;
  for (const auto& [arrives_s, report] : test::deliveries_of(tracks)) {
    ASSERT_TRUE(swarm.update(report).has_value());
    if (arrives_s > last_s) test::take_all(swarm, arrives_s, events);
    last_s = arrives_s;
  }
  const auto rest = swarm.finish(last_s);
  ASSERT_TRUE(rest.has_value());
  events.insert(events.end(), rest->begin(), rest->end());
  std::map<std::pair<AgentId, AgentId>, int> open;
  for (const SwarmEvent& event : events) {
    int& is_open = open[{event.first, event.second}];
    if (event.kind == EventKind::kEntered) {
      EXPECT_EQ(++is_open, 1);
    }
    if (event.kind == EventKind::kLeft || event.kind == EventKind::kLost ||
        event.kind == EventKind::kEnded) {
      EXPECT_EQ(--is_open, 0);
    }
  }
  for (const auto& [pair, is_open] : open) EXPECT_EQ(is_open, 0);
  EXPECT_FALSE(overloads(events, SwarmBound::kPairs).empty());
  EXPECT_GT(test::of_kind(events, EventKind::kEntered).size(), 50U);
}

// Thousands of bees at one place: that is reported, within the memory of the bound.
TEST(SwarmBounds, HoldWhereAllAreAtOnePlace) {
  SwarmOptions options{.threshold_m = 20.0};
  options.max_pairs = 1000;
  Swarm swarm(options);
  const PointId bees = test::kSanitized ? 600 : 3000;
  Events events;
  for (const double time_s : {0.0, 1.0, 2.0}) {
    for (AgentId id = 0; id < bees; ++id) {
      ASSERT_TRUE(swarm.update({id, time_s, {1, 2, 3}}).has_value());
    }
    test::take_all(swarm, time_s, events);
  }
  EXPECT_EQ(test::of_kind(events, EventKind::kEntered).size(), 1000U);
  EXPECT_EQ(overloads(events, SwarmBound::kPairs).size(), 3U);
  EXPECT_EQ(overloads(events, SwarmBound::kPredicted).size(), 2U);
  // They disperse, and all events are reported again.
  for (const double time_s : {3.0, 4.0, 5.0}) {
    events.clear();
    for (PointId id = 0; id < bees; ++id) {
      ASSERT_TRUE(swarm.update({id, time_s, {100.0 * id, 2, 3}}).has_value());
    }
    test::take_all(swarm, time_s, events);
  }
  EXPECT_TRUE(test::of_kind(events, EventKind::kOverloaded).empty());
}

// Possible conflicts are bounded too, and the closest come first.
TEST(SwarmBounds, OfPossibleConflictsKeepTheClosest) {
  SwarmOptions options{.threshold_m = 1.0};
  options.max_speed_mps = 10.0;
  options.max_pairs = 5;
  options.horizon_s = 0.0;
  Swarm swarm(options);
  Events events;
  for (double time_s = 0.0; time_s <= 20.0; time_s += 1.0) {
    for (PointId id = time_s > 0.0 ? 1 : 0; id < 20; ++id) {
      ASSERT_TRUE(swarm.update({id, time_s, {10.0 * id, 0, 0}}).has_value());
    }
    if (time_s == 0.0 || time_s == 20.0) test::take_all(swarm, time_s, events);
  }
  const Events possible = test::of_kind(events, EventKind::kPossible);
  ASSERT_EQ(possible.size(), 5U);
  for (const SwarmEvent& event : possible) EXPECT_LE(event.second, 5U);
  const Events left_out = overloads(events, SwarmBound::kPossible);
  ASSERT_EQ(left_out.size(), 1U);
  EXPECT_EQ(left_out[0].count, 14U);
  EXPECT_EQ(left_out[0].distance_m, 60.0);
}

}  // namespace
}  // namespace beespace
