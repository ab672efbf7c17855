// What a live swarm says of the future: in time, once an encounter, and as it then comes.
#include "tests/support/conflict_printer.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/swarm_replay.hpp"

#include <beespace/predict_conflicts.hpp>
#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace beespace {
namespace {

using test::Events;

SwarmOptions looking_ahead(double horizon_s) {
  SwarmOptions options;
  options.threshold_m = 20.0;
  options.horizon_s = horizon_s;
  return options;
}

// Two bees 200 m apart, 5 m/s each towards the other, 3 m beside: closest at 20 s.
PositionReport head_on(AgentId id, double time_s, bool says_velocity) {
  const double side = id == 1 ? -1.0 : 1.0;
  PositionReport report{id, time_s, {side * (100.0 - 5.0 * time_s), id == 1 ? 0.0 : 3.0, 0.0}};
  if (says_velocity) report.velocity = Velocity{-5.0 * side, 0.0, 0.0};
  return report;
}

struct TimedEvent {
  double now_s;
  SwarmEvent event;
};

std::vector<TimedEvent> events_of_head_on(const SwarmOptions& options, bool says_velocity,
                                          double until_s) {
  Swarm swarm(options);
  std::vector<TimedEvent> timed;
  for (double now = 0.0; now <= until_s; now += 0.5) {
    for (const AgentId id : {1U, 2U}) {
      EXPECT_TRUE(swarm.update(head_on(id, now, says_velocity)).has_value());
    }
    Events events;
    test::take_all(swarm, now, events);
    for (const SwarmEvent& event : events) timed.push_back({now, event});
  }
  return timed;
}

TEST(SwarmPrediction, OfAHeadOnPairComesOnceAndIsTrue) {
  const double begins_s = 20.0 - std::sqrt(400.0 - 9.0) / 10.0;
  for (const bool says_velocity : {false, true}) {
    const std::vector<TimedEvent> timed =
        events_of_head_on(looking_ahead(10.0), says_velocity, 40.0);
    ASSERT_EQ(timed.size(), 4U);  // predicted, entered, closest passed, left
    EXPECT_EQ(timed[0].event.kind, EventKind::kPredicted);
    EXPECT_EQ(timed[0].now_s, std::ceil(2.0 * (begins_s - 10.0)) / 2.0) << "as soon as it can be";
    EXPECT_NEAR(timed[0].event.time_s, begins_s, 1e-9);
    // Of the closest, what lies before the horizon.
    const double closest_s = timed[0].now_s + 10.0;
    EXPECT_NEAR(timed[0].event.closest_s, closest_s, 1e-9);
    EXPECT_NEAR(timed[0].event.distance_m, std::hypot(3.0, 200.0 - 10.0 * closest_s), 1e-9);
    EXPECT_EQ(timed[0].event.first, 1U);
    EXPECT_EQ(timed[0].event.second, 2U);
    EXPECT_EQ(timed[1].event.kind, EventKind::kEntered);
    EXPECT_NEAR(timed[1].event.time_s, begins_s, 1e-9);
    EXPECT_EQ(timed[2].event.kind, EventKind::kClosestPassed);
    EXPECT_NEAR(timed[2].event.time_s, 20.0, 1e-9);
    EXPECT_EQ(timed[3].event.kind, EventKind::kLeft);
  }
}

TEST(SwarmPrediction, WithoutAHorizonThereIsNone) {
  for (const TimedEvent& one : events_of_head_on(looking_ahead(0.0), true, 40.0)) {
    EXPECT_NE(one.event.kind, EventKind::kPredicted);
  }
}

TEST(SwarmPrediction, IsNotMadeFromOneReportWithoutAVelocity) {
  Swarm swarm(looking_ahead(10.0));
  ASSERT_TRUE(swarm.update({1, 0.0, {0, 0, 0}}).has_value());
  ASSERT_TRUE(swarm.update({2, 0.0, {60, 0, 0}, Velocity{-5, 0, 0}}).has_value());
  EXPECT_TRUE(swarm.advance(0.0).value().empty());
  ASSERT_TRUE(swarm.update({1, 0.5, {0, 0, 0}}).has_value());
  const Events events = *swarm.advance(0.5);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::kPredicted);
  EXPECT_NEAR(events[0].time_s, 8.0, 1e-9);
  EXPECT_NEAR(events[0].distance_m, 7.5, 1e-9) << "where the horizon ends";
}

// The position is extrapolated from an older report.
TEST(SwarmPrediction, IsMadeFromWhereBeesAreByNow) {
  Swarm swarm(looking_ahead(10.0));
  for (const AgentId id : {1U, 2U}) {
    ASSERT_TRUE(swarm.update(head_on(id, id == 1 ? 6.0 : 8.0, true)).has_value());
  }
  const Events events = *swarm.advance(10.5);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_NEAR(events[0].time_s, 20.0 - std::sqrt(400.0 - 9.0) / 10.0, 1e-9);
  EXPECT_NEAR(events[0].closest_s, 20.0, 1e-9);
  EXPECT_NEAR(events[0].distance_m, 3.0, 1e-9);
}

// It turns away, and then towards the other again: danger, none, danger.
TEST(SwarmPrediction, ComesAgainOnlyAfterThePairWasOutOfDanger) {
  Swarm swarm(looking_ahead(10.0));
  std::vector<double> predicted_at;
  double x = 100.0;
  for (int i = 0; i < 40; ++i) {
    const double speed = i < 6 || i >= 14 ? -10.0 : 10.0;
    EXPECT_TRUE(swarm.update({1, 1.0 * i, {0, 0, 0}, Velocity{}}).has_value());
    EXPECT_TRUE(swarm.update({2, 1.0 * i, {x, 0, 0}, Velocity{speed, 0, 0}}).has_value());
    Events events;
    test::take_all(swarm, i, events);
    for (const SwarmEvent& event : test::of_kind(events, EventKind::kPredicted)) {
      predicted_at.push_back(i);
      EXPECT_NEAR(event.time_s, i + (x - 20.0) / 10.0, 1e-9);
    }
    x += speed;
  }
  ASSERT_EQ(predicted_at.size(), 2U);
  EXPECT_EQ(predicted_at[0], 0.0);
  EXPECT_GE(predicted_at[1], 14.0);
}

// Velocities that waver around danger do not repeat the prediction.
TEST(SwarmPrediction, DoesNotFlap) {
  Swarm swarm(looking_ahead(10.0));
  std::size_t predicted = 0;
  for (int i = 0; i < 12; ++i) {
    const double miss = i % 2 == 0 ? 19.0 : 21.0;  // the leave threshold is 22 m
    const double x = 150.0 - 10.0 * i;
    EXPECT_TRUE(swarm.update({1, 1.0 * i, {0, 0, 0}, Velocity{}}).has_value());
    EXPECT_TRUE(swarm.update({2, 1.0 * i, {x, miss, 0}, Velocity{-10, 0, 0}}).has_value());
    Events events;
    test::take_all(swarm, i, events);
    predicted += test::of_kind(events, EventKind::kPredicted).size();
  }
  EXPECT_EQ(predicted, 1U);
}

// Of many bees: what predict_conflicts() finds for the same states.
TEST(SwarmPrediction, OfManyIsThatOfPredictConflicts) {
  test::SceneMaker make(808);
  std::size_t predicted = 0;
  for (int round = 0; round < test::rounds(30); ++round) {
    const std::vector<Mover> movers = test::flying(make, 80, {600, 600, 100}, 12);
    Swarm swarm(looking_ahead(8.0));
    for (AgentId id = 0; id < movers.size(); ++id) {
      ASSERT_TRUE(
          swarm.update({1000 - id, 5.0, movers[id].position, movers[id].velocity}).has_value());
    }
    const Events all = *swarm.advance(5.0);
    const Events events = test::of_kind(all, EventKind::kPredicted);
    const Events entered = test::of_kind(all, EventKind::kEntered);
    PredictOptions options;
    options.threshold_m = 20.0;
    options.horizon_s = 8.0;
    const auto expected = *predict_conflicts(movers, options);
    ASSERT_EQ(events.size() + entered.size(), expected.size());
    for (const Conflict& conflict : expected) {
      if (conflict.begins_s == 0.0) continue;  // entered
      const auto same = [&](const SwarmEvent& event) {
        return event.kind == EventKind::kPredicted && event.first == 1000 - conflict.second &&
               event.second == 1000 - conflict.first &&
               std::abs(event.time_s - 5.0 - conflict.begins_s) < 1e-9 &&
               std::abs(event.distance_m - conflict.closest_m) < 1e-9;
      };
      EXPECT_EQ(std::count_if(events.begin(), events.end(), same), 1);
    }
    predicted += events.size();
  }
  EXPECT_GT(predicted, static_cast<std::size_t>(test::rounds(200)));
}

}  // namespace
}  // namespace beespace
