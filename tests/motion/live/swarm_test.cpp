// What a live swarm promises, case by case, on encounters that are easy to check by hand.
#include "tests/support/conflict_printer.hpp"
#include "tests/support/swarm_replay.hpp"

#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

namespace beespace {
namespace {

using test::Events;

// Closer than 20 m; 22 m to leave; no predictions.
SwarmOptions plain_options() {
  SwarmOptions options;
  options.threshold_m = 20.0;
  options.horizon_s = 0.0;
  return options;
}

Events advanced(Swarm& swarm, double now_s) {
  Events events;
  test::take_all(swarm, now_s, events);
  return events;
}

void hear(Swarm& swarm, const PositionReport& report) {
  const Status taken = swarm.update(report);
  ASSERT_TRUE(taken.has_value()) << taken.error().message;
}

std::size_t count(const Events& events, EventKind kind) {
  return test::of_kind(events, kind).size();
}

// Bee 3 hovers; bee 8 is at these distances from it, a second each. All events until then.
Events events_of_distances(Swarm& swarm, const std::vector<double>& distances_m,
                           double begin_s = 0) {
  Events events;
  for (std::size_t i = 0; i < distances_m.size(); ++i) {
    const double time = begin_s + static_cast<double>(i);
    hear(swarm, {3, time, {0, 0, 0}});
    hear(swarm, {8, time, {distances_m[i], 0, 0}});
    test::take_all(swarm, time, events);
  }
  return events;
}

TEST(SwarmEvents, OfAPassAreEnteredClosestPassedAndLeft) {
  Swarm swarm(plain_options());
  const Events events = events_of_distances(swarm, {30, 10, 5, 10, 24, 30});
  const Events expected = {{EventKind::kEntered, 0.5, 3, 8, 20, 1},
                           {EventKind::kClosestPassed, 2, 3, 8, 5, 2},
                           {EventKind::kLeft, 4.0 - 2.0 / 14.0, 3, 8, 22, 2}};
  ASSERT_EQ(events.size(), expected.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    EXPECT_EQ(events[k].kind, expected[k].kind);
    EXPECT_NEAR(events[k].time_s, expected[k].time_s, 1e-12);
    EXPECT_EQ(events[k].first, 3U);
    EXPECT_EQ(events[k].second, 8U);
    EXPECT_NEAR(events[k].distance_m, expected[k].distance_m, 1e-12);
    EXPECT_NEAR(events[k].closest_s, expected[k].closest_s, 1e-12);
  }
}

// The velocity between two reports may be smaller than any that is valid as input.
TEST(SwarmEvents, AreReportedOfBeesThatHardlyMove) {
  SwarmOptions options = plain_options();
  options.horizon_s = 10.0;
  Swarm swarm(options);
  hear(swarm, {77, 0.0, {6.123233995736766e-17, 900, 0}});
  hear(swarm, {77, 1.0, {std::nextafter(6.123233995736766e-17, 1.0), 900, 0}});
  const Events events = events_of_distances(swarm, {30, 10, 5, 10, 24, 30}, 0.5);
  for (const EventKind kind : {EventKind::kEntered, EventKind::kClosestPassed, EventKind::kLeft}) {
    EXPECT_EQ(count(events, kind), 1U) << static_cast<int>(kind);
  }
}

TEST(SwarmEvents, AreReportedAsSoonAsBothAreHeardAgain) {
  Swarm swarm(plain_options());
  EXPECT_TRUE(events_of_distances(swarm, {30, 25}).empty());
  hear(swarm, {8, 2.0, {10, 0, 0}});
  EXPECT_TRUE(advanced(swarm, 2.5).empty()) << "where the other was at 2 s is not known";
  hear(swarm, {3, 3.0, {0, 0, 0}});
  EXPECT_EQ(count(advanced(swarm, 3.0), EventKind::kEntered), 1U);
}

// Back and forth across the threshold, and once across that of leaving.
TEST(SwarmEvents, DoNotFlapBetweenTheThresholds) {
  const std::vector<double> distances = {30, 19, 21, 19, 21.9, 18, 21, 19, 23, 19, 21, 40};
  Swarm calm(plain_options());
  const Events events = events_of_distances(calm, distances);
  EXPECT_EQ(count(events, EventKind::kEntered), 2U);
  EXPECT_EQ(count(events, EventKind::kLeft), 2U);
  EXPECT_EQ(count(events, EventKind::kClosestPassed), 2U);
  SwarmOptions nervous_options = plain_options();
  nervous_options.leave_factor = 1.0;
  Swarm nervous(nervous_options);
  const Events more = events_of_distances(nervous, distances);
  EXPECT_EQ(count(more, EventKind::kEntered), 5U);
  EXPECT_EQ(count(more, EventKind::kLeft), 5U);
}

TEST(SwarmEvents, DoNotComeWithoutCrossingTheThreshold) {
  Swarm swarm(plain_options());
  EXPECT_TRUE(events_of_distances(swarm, {30, 21, 20, 21, 30}).empty());
}

// The closest distance is reported again only when it is clearly less than before.
TEST(SwarmEvents, ReportTheClosestAgainOnlyWhenItIsClearlyCloser) {
  Swarm swarm(plain_options());
  const Events closest = test::of_kind(
      events_of_distances(swarm, {30, 15, 18, 14.5, 18, 8, 18, 30}), EventKind::kClosestPassed);
  ASSERT_EQ(closest.size(), 2U);
  EXPECT_NEAR(closest[0].distance_m, 15.0, 1e-12);
  EXPECT_NEAR(closest[1].distance_m, 8.0, 1e-12);
}

TEST(SwarmEvents, OfHoveringBeesAreReportedOnce) {
  Swarm swarm(plain_options());
  const Events events = events_of_distances(swarm, std::vector<double>(50, 7.0));
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::kEntered);
  EXPECT_EQ(events[0].time_s, 0.0);
  EXPECT_EQ(events[0].distance_m, 7.0);
}

TEST(SwarmRemoval, EndsAnEncounter) {
  Swarm swarm(plain_options());
  EXPECT_EQ(count(events_of_distances(swarm, {30, 10, 9}), EventKind::kEntered), 1U);
  swarm.remove(8);
  swarm.remove(8);
  swarm.remove(77);  // never heard of
  const Events left = test::of_kind(advanced(swarm, 2.5), EventKind::kLeft);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].time_s, 2.0);
  EXPECT_NEAR(left[0].distance_m, 9.0, 1e-12);
  EXPECT_EQ(swarm.counts().agents, 1U);
  EXPECT_EQ(swarm.counts().stale, 0U);
  EXPECT_TRUE(advanced(swarm, 3.0).empty());
}

TEST(SwarmRemoval, LetsABeeComeBackAsANewOne) {
  Swarm swarm(plain_options());
  events_of_distances(swarm, {30, 10, 9});
  swarm.remove(8);
  advanced(swarm, 2.5);
  // Between its removal and its return it does not pass any bee.
  const Events events = events_of_distances(swarm, {10, 10, 40}, 3.0);
  const Events entered = test::of_kind(events, EventKind::kEntered);
  ASSERT_EQ(entered.size(), 1U);
  EXPECT_EQ(entered[0].time_s, 3.0);
}

TEST(SwarmStaleness, EndsEncountersAndIsReportedOnce) {
  Swarm swarm(plain_options());  // 5 s
  events_of_distances(swarm, {30, 10, 9});
  for (int i = 3; i <= 7; ++i) {
    hear(swarm, {3, 1.0 * i, {0, 0, 0}});
    EXPECT_TRUE(advanced(swarm, i).empty()) << "heard of " << i - 2 << " s ago";
  }
  hear(swarm, {3, 8.0, {0, 0, 0}});
  const Events events = advanced(swarm, 8.0);
  ASSERT_EQ(count(events, EventKind::kStale), 1U);
  const SwarmEvent stale = test::of_kind(events, EventKind::kStale)[0];
  EXPECT_EQ(stale.first, 8U);
  EXPECT_EQ(stale.second, 8U);
  ASSERT_EQ(count(events, EventKind::kLost), 1U);
  const SwarmEvent lost = test::of_kind(events, EventKind::kLost)[0];
  EXPECT_EQ(lost.time_s, 2.0);
  EXPECT_EQ(lost.since_s, 2.0);
  EXPECT_EQ(lost.distance_m, 9.0);
  EXPECT_EQ(events.size(), 2U) << "they have neither passed nor left";
  EXPECT_EQ(swarm.counts().agents, 1U);
  EXPECT_EQ(swarm.counts().stale, 1U);
  hear(swarm, {3, 9.0, {0, 0, 0}});
  EXPECT_TRUE(advanced(swarm, 9.0).empty());
}

TEST(SwarmStaleness, LetsABeeComeBackAndEnterAnew) {
  Swarm swarm(plain_options());
  events_of_distances(swarm, {30, 10, 9});
  for (int i = 3; i <= 9; ++i) {
    hear(swarm, {3, 1.0 * i, {0, 0, 0}});
    advanced(swarm, i);
  }
  const Events events = events_of_distances(swarm, {10, 9, 30}, 10.0);
  EXPECT_EQ(swarm.counts().stale, 0U);
  EXPECT_EQ(swarm.counts().agents, 2U);
  const Events entered = test::of_kind(events, EventKind::kEntered);
  ASSERT_EQ(entered.size(), 1U);
  EXPECT_EQ(entered[0].time_s, 10.0) << "its place before that is unknown";
}

TEST(SwarmStaleness, IsNotEndedByWhatWasHeardBefore) {
  Swarm swarm(plain_options());
  hear(swarm, {8, 9.0, {0, 0, 0}});
  hear(swarm, {8, 10.0, {1, 0, 0}});
  EXPECT_EQ(count(advanced(swarm, 20.0), EventKind::kStale), 1U);
  hear(swarm, {8, 10.0, {1, 0, 0}});
  hear(swarm, {8, 9.5, {1, 0, 0}});
  EXPECT_EQ(swarm.counts().taken, 2U);
  EXPECT_EQ(swarm.counts().repeated + swarm.counts().late, 2U);
  EXPECT_EQ(swarm.counts().stale, 1U);
  EXPECT_TRUE(advanced(swarm, 21.0).empty()) << "that it is stale has been said";
}

TEST(SwarmHeights, AreComparedWithTheHeightWhetherApartOrNot) {
  for (const bool apart : {false, true}) {
    for (const double height : {4.0, 6.0}) {
      SwarmOptions options = plain_options();
      options.vertical_m = 5.0;
      options.heights_apart = apart;
      options.horizon_s = 10.0;
      Swarm swarm(options);
      Events events;
      for (int i = 0; i <= 12; ++i) {
        const double x = 100.0 - 10.0 * i;
        hear(swarm, {1, 1.0 * i, {0, 0, 0}, Velocity{0, 0, 0}, 0.0, 0.0});
        hear(swarm, {2,
                     1.0 * i,
                     {x, 0, apart ? 0.0 : height},
                     Velocity{-10, 0, 0},
                     apart ? height : 0.0,
                     0.0});
        test::take_all(swarm, i, events);
      }
      const std::size_t expected = height < 5.0 ? 1 : 0;
      EXPECT_EQ(count(events, EventKind::kPredicted), expected) << height;
      EXPECT_EQ(count(events, EventKind::kEntered), expected) << height;
    }
  }
}

// It climbs, first by its reported rate, then by the rate between reports.
TEST(SwarmHeights, ThatChangeArePredicted) {
  for (const bool says_so : {false, true}) {
    SwarmOptions options = plain_options();
    options.vertical_m = 5.0;
    options.heights_apart = true;
    options.horizon_s = 30.0;
    Swarm swarm(options);
    for (int i = 0; i < 2; ++i) {
      std::optional<Velocity> velocity;
      if (says_so) velocity = Velocity{};
      hear(swarm, {1, 1.0 * i, {0, 0, 0}, velocity, 100.0, 0.0});
      hear(swarm, {2, 1.0 * i, {5, 0, 0}, velocity, 40.0 + 3.0 * i, 3.0});
    }
    const Events events = advanced(swarm, 1.0);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::kPredicted);
    EXPECT_NEAR(events[0].time_s, 55.0 / 3.0, 1e-9) << "5 m below";
  }
}

// In seconds since 1970 doubles are 2.4e-7 apart. An age is the difference of two such times, and
// is not compared with a rounded time.
TEST(SwarmEvents, AnAgeIsTheDifferenceOfTwoTimes) {
  constexpr double kTick = 0x1p-22;
  SwarmOptions options = plain_options();
  options.max_age_s = 3.5 * kTick;
  for (const int ticks : {3, 4}) {
    Swarm swarm(options);
    hear(swarm, {1, 1.7e9 + 10 * kTick, {0, 0, 0}});
    EXPECT_EQ(count(advanced(swarm, 1.7e9 + (10 + ticks) * kTick), EventKind::kStale),
              ticks == 3 ? 0U : 1U);
  }
}

TEST(SwarmMove, TakesAllThatIsKnownAlong) {
  Swarm swarm(plain_options());
  events_of_distances(swarm, {30, 10});
  Swarm other(std::move(swarm));
  EXPECT_EQ(count(events_of_distances(other, {9, 30}, 2.0), EventKind::kLeft), 1U);
  Swarm third(plain_options());
  third = std::move(other);
  EXPECT_EQ(third.counts().taken, 8U);
}

TEST(Swarm, IdsAreOfAnySize) {
  constexpr AgentId kFirst = 0x1234567800000003;
  constexpr AgentId kSecond = 0xffffffff00000003;  // the same in 32 bits
  SwarmOptions options{.threshold_m = 5.0, .horizon_s = 4.0, .max_age_s = 2.0};
  options.max_speed_mps = 10.0;
  Swarm swarm(options);
  Events events;
  for (int second = 0; second <= 20; ++second) {
    const double time_s = second;
    ASSERT_TRUE(swarm.update({kFirst, time_s, {-20.0 + 3.0 * time_s, 0.0, 0.0}}).has_value());
    if (second <= 8 || second == 20) {
      ASSERT_TRUE(swarm.update({kSecond, time_s, {20.0 - 3.0 * time_s, 1.0, 0.0}}).has_value());
    }
    test::take_all(swarm, time_s, events);
  }
  std::set<EventKind> kinds;
  for (const SwarmEvent& event : events) {
    kinds.insert(event.kind);
    const bool of_one = event.first == event.second;
    EXPECT_EQ(event.first, of_one ? kSecond : kFirst);
    EXPECT_EQ(event.second, kSecond);
  }
  EXPECT_EQ(kinds,
            (std::set<EventKind>{EventKind::kPredicted, EventKind::kPossible, EventKind::kHeard,
                                 EventKind::kEntered, EventKind::kClosestPassed, EventKind::kLeft,
                                 EventKind::kStale}));
}

}  // namespace
}  // namespace beespace
