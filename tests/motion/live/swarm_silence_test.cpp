// Silence is not absence: the events of bees that fall silent, in every phase of an encounter, and
// when they are heard again.
#include "tests/support/conflict_printer.hpp"
#include "tests/support/swarm_replay.hpp"

#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using test::Events;

// Closer than 20 m, 22 m to leave; stale after 2 s.
SwarmOptions options_with(double horizon_s = 0.0) {
  SwarmOptions options{.threshold_m = 20.0};
  options.horizon_s = horizon_s;
  options.max_age_s = 2.0;
  return options;
}

void hear(Swarm& swarm, AgentId id, double time_s, double x) {
  ASSERT_TRUE(swarm.update({id, time_s, {x, 0, 0}}).has_value());
}

std::size_t count(const Events& events, EventKind kind) {
  return test::of_kind(events, kind).size();
}

// Bee 1 hovers. Bee 2 comes from 60 m at 5 m/s, passes at 12 s and flies away; it is not heard of
// after `silent_s`, nor until `returns_s`. Looks every half second, to 30 s.
Events events_of_a_pass(double silent_s, double returns_s = 1e9,
                        SwarmOptions options = options_with()) {
  Swarm swarm(options);
  Events events;
  for (int half = 0; half <= 60; ++half) {
    const double time_s = 0.5 * half;
    hear(swarm, 1, time_s, 0.0);
    if (time_s <= silent_s || time_s >= returns_s) hear(swarm, 2, time_s, 60.0 - 5.0 * time_s);
    test::take_all(swarm, time_s, events);
  }
  return events;
}

// For each phase: entered at 8 s, closest at 12 s, left at 16.4 s.
TEST(SwarmSilence, IsReportedAsSuchInEveryPhaseOfAnEncounter) {
  for (double silent_s = 0.0; silent_s <= 20.0; silent_s += 0.5) {
    SCOPED_TRACE(silent_s);
    const Events events = events_of_a_pass(silent_s);
    const bool entered = silent_s > 8.0;
    const bool left = silent_s >= 16.5;
    EXPECT_EQ(count(events, EventKind::kStale), 1U);
    EXPECT_EQ(count(events, EventKind::kEntered), entered ? 1U : 0U);
    EXPECT_EQ(count(events, EventKind::kLeft), left ? 1U : 0U);
    EXPECT_EQ(count(events, EventKind::kLost), entered && !left ? 1U : 0U);
    // The margin by which they must be farther apart again is 2 m.
    EXPECT_EQ(count(events, EventKind::kClosestPassed), silent_s >= 12.5 ? 1U : 0U);
    for (const SwarmEvent& lost : test::of_kind(events, EventKind::kLost)) {
      EXPECT_EQ(lost.time_s, silent_s);
      EXPECT_EQ(lost.since_s, silent_s);
      EXPECT_NEAR(lost.distance_m, std::abs(60.0 - 5.0 * silent_s), 1e-12);
    }
  }
}

// Two bees close in head on; one falls silent at 20 m.
TEST(SwarmSilence, OfABeeThatComesHeadOnIsNoAllClear) {
  SwarmOptions options{.threshold_m = 25.0};
  options.max_speed_mps = 12.0;
  Swarm swarm(options);
  Events events;
  for (int tenth = 0; tenth <= 200; ++tenth) {
    const double time_s = 0.1 * tenth;
    ASSERT_TRUE(swarm.update({1, time_s, {10.0 * time_s, 0, 0}, Velocity{10, 0, 0}}).has_value());
    if (tenth <= 90) {
      const Point at{200.0 - 10.0 * time_s, 0, 0};
      ASSERT_TRUE(swarm.update({2, time_s, at, Velocity{-10, 0, 0}}).has_value());
    }
    test::take_all(swarm, time_s, events);
  }
  EXPECT_EQ(count(events, EventKind::kPredicted), 1U);
  EXPECT_EQ(count(events, EventKind::kEntered), 1U);
  EXPECT_EQ(count(events, EventKind::kStale), 1U);
  ASSERT_EQ(count(events, EventKind::kLost), 1U);
  EXPECT_NEAR(test::of_kind(events, EventKind::kLost)[0].distance_m, 20.0, 1e-9);
  EXPECT_EQ(count(events, EventKind::kPossible), 1U);
  EXPECT_EQ(count(events, EventKind::kClosestPassed), 0U);
  EXPECT_EQ(count(events, EventKind::kLeft), 0U);
}

TEST(SwarmSilence, EndsWithWhatIsThereThen) {
  // It returns at 10 m, on the other side: inside.
  const Events inside = events_of_a_pass(10.0, 14.0);
  ASSERT_EQ(count(inside, EventKind::kHeard), 1U);
  const SwarmEvent heard = test::of_kind(inside, EventKind::kHeard)[0];
  EXPECT_EQ(heard.time_s, 14.0);
  EXPECT_EQ(heard.since_s, 10.0);
  EXPECT_EQ(heard.first, 2U);
  EXPECT_EQ(heard.second, 2U);
  const Events entered = test::of_kind(inside, EventKind::kEntered);
  ASSERT_EQ(entered.size(), 2U);
  EXPECT_EQ(entered[1].time_s, 14.0);
  EXPECT_EQ(entered[1].distance_m, 10.0);
  EXPECT_EQ(count(inside, EventKind::kLost), 1U);
  EXPECT_EQ(count(inside, EventKind::kLeft), 1U);
  // And outside.
  const Events outside = events_of_a_pass(10.0, 20.0);
  EXPECT_EQ(count(outside, EventKind::kHeard), 1U);
  EXPECT_EQ(count(outside, EventKind::kEntered), 1U);
  EXPECT_EQ(count(outside, EventKind::kLost), 1U);
  EXPECT_EQ(count(outside, EventKind::kLeft), 0U);
  EXPECT_EQ(count(outside, EventKind::kClosestPassed), 0U) << "it was not observed";
}

// The events are the same if none were asked for during the silence.
TEST(SwarmSilence, IsReportedHoweverSeldomEventsAreAskedFor) {
  for (const double every_s : {0.5, 3.0, 100.0}) {
    Swarm swarm(options_with());
    Events events;
    double look_s = 0.0;
    for (int half = 0; half <= 40; ++half) {
      const double time_s = 0.5 * half;
      hear(swarm, 1, time_s, 0.0);
      if (time_s <= 9.0 || time_s >= 12.5) hear(swarm, 2, time_s, 60.0 - 5.0 * time_s);
      if (time_s >= look_s) test::take_all(swarm, time_s, events);
      if (time_s >= look_s) look_s += every_s;
    }
    test::take_all(swarm, 20.0, events);
    EXPECT_EQ(count(events, EventKind::kStale), 1U);
    EXPECT_EQ(count(events, EventKind::kHeard), 1U);
    EXPECT_EQ(count(events, EventKind::kLost), 1U);
    EXPECT_EQ(count(events, EventKind::kEntered), 2U);
    EXPECT_EQ(count(events, EventKind::kLeft), 1U);
  }
}

TEST(SwarmSilence, OfBothIsOneLoss) {
  Swarm swarm(options_with());
  Events events;
  hear(swarm, 1, 0.0, 0.0);
  hear(swarm, 2, 0.0, 3.0);
  hear(swarm, 1, 1.0, 0.0);
  hear(swarm, 2, 1.5, 3.0);
  test::take_all(swarm, 10.0, events);
  EXPECT_EQ(count(events, EventKind::kEntered), 1U);
  ASSERT_EQ(count(events, EventKind::kLost), 1U);
  EXPECT_EQ(test::of_kind(events, EventKind::kLost)[0].time_s, 1.0);
  EXPECT_EQ(count(events, EventKind::kStale), 2U);
  EXPECT_EQ(events.size(), 4U);
}

// A bee that is removed during a conflict has left, even if the other one's reports up to then come
// only afterwards.
TEST(SwarmRemoval, TakesNothingBackThatHappenedBefore) {
  Swarm swarm(options_with());
  Events events;
  hear(swarm, 1, 0.0, 100.0);
  hear(swarm, 2, 0.0, 0.0);
  hear(swarm, 1, 0.9, 100.0);
  hear(swarm, 2, 1.0, 95.0);
  test::take_all(swarm, 1.0, events);
  swarm.remove(2);
  test::take_all(swarm, 1.0, events);
  hear(swarm, 1, 1.1, 100.0);
  test::take_all(swarm, 1.1, events);
  ASSERT_EQ(count(events, EventKind::kEntered), 1U);
  ASSERT_EQ(count(events, EventKind::kLeft), 1U);
  EXPECT_EQ(test::of_kind(events, EventKind::kLeft)[0].time_s, 1.0);
  EXPECT_EQ(events.size(), 2U);
}

TEST(SwarmRemoval, OfALostBeeReportsNothingMore) {
  Swarm swarm(options_with());
  Events events;
  hear(swarm, 1, 0.0, 0.0);
  hear(swarm, 2, 0.0, 3.0);
  for (double time_s = 1.0; time_s <= 5.0; time_s += 1.0) {
    hear(swarm, 1, time_s, 0.0);
    test::take_all(swarm, time_s, events);
  }
  EXPECT_EQ(count(events, EventKind::kLost), 1U);
  EXPECT_EQ(swarm.counts().stale, 1U);
  swarm.remove(2);
  EXPECT_EQ(swarm.counts().stale, 0U);
  const std::size_t before = events.size();
  test::take_all(swarm, 6.0, events);
  EXPECT_EQ(events.size(), before);
}

// One report each, or one report and a track: a conflict is there as in a recording.
TEST(SwarmOfOneReport, IsInConflictAtThatInstant) {
  Swarm swarm(options_with());
  Events events;
  hear(swarm, 1, 1.0, 0.0);
  hear(swarm, 2, 1.0, 3.0);
  test::take_all(swarm, 1.0, events);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::kEntered);
  EXPECT_EQ(events[0].time_s, 1.0);
  EXPECT_EQ(events[0].distance_m, 3.0);

  Swarm other(options_with());
  Events beside;
  for (double time_s = 0.25; time_s < 3.0; time_s += 0.5) hear(other, 1, time_s, 0.0);
  hear(other, 2, 1.0, 3.0);
  test::take_all(other, 2.75, beside);
  ASSERT_EQ(beside.size(), 1U);
  EXPECT_EQ(beside[0].time_s, 1.0);
}

TEST(SwarmFinish, ReportsWhatIsKnownAndForgetsAll) {
  Swarm swarm(options_with());
  hear(swarm, 1, 5.0, 0.0);
  hear(swarm, 2, 5.0, 3.0);
  hear(swarm, 2, 6.0, 3.0);
  const auto last = swarm.finish(6.0);
  ASSERT_TRUE(last.has_value());
  ASSERT_EQ(last->size(), 2U);
  EXPECT_EQ((*last)[0].kind, EventKind::kEntered);
  EXPECT_EQ((*last)[1].kind, EventKind::kEnded);
  EXPECT_EQ((*last)[1].time_s, 5.0) << "up to when both are known";
  EXPECT_EQ(swarm.counts().agents, 0U);
  EXPECT_EQ(swarm.counts().taken, 3U);
  EXPECT_TRUE(swarm.movers(6.0).empty());
  // Clocks begin anew.
  hear(swarm, 1, 0.0, 0.0);
  hear(swarm, 2, 0.0, 3.0);
  const auto again = swarm.advance(0.0);
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(count(*again, EventKind::kEntered), 1U);
}

TEST(SwarmSilences, AreCountedUntilNow) {
  Swarm swarm(options_with());
  hear(swarm, 1, 0.0, 0.0);
  hear(swarm, 2, 0.0, 100.0);
  hear(swarm, 1, 1.0, 0.0);
  ASSERT_TRUE(swarm.advance(1.0).has_value());
  EXPECT_TRUE(swarm.silences(1.0).empty());
  hear(swarm, 1, 4.0, 0.0);
  ASSERT_TRUE(swarm.advance(4.0).has_value());
  const std::vector<Silence> silences = swarm.silences(4.0);
  EXPECT_EQ(silences, (std::vector<Silence>{{1, 3.0, {}}, {2, 4.0, 0.0}}));
  EXPECT_EQ(swarm.counts().unknown_s, 3.0);
  swarm.remove(1);
  EXPECT_EQ(swarm.counts().unknown_s, 3.0) << "removed ones included";
  EXPECT_EQ(swarm.silences(5.0), (std::vector<Silence>{{2, 5.0, 0.0}}));
}

// 100 m apart, at most 10 m/s each, a threshold of 20 m: both together bridge 80 m from their last
// positions.
TEST(SwarmPossible, ComesWhenTheBallsReachEachOther) {
  for (const bool both : {false, true}) {
    SwarmOptions options = options_with();
    options.max_speed_mps = 10.0;
    Swarm swarm(options);
    hear(swarm, 1, 0.0, 0.0);
    Events events;
    double reported_s = -1.0;
    for (double time_s = 0.0; time_s <= 12.0; time_s += 0.25) {
      if (time_s == 0.0 || !both) hear(swarm, 2, time_s, 100.0);
      const std::size_t before = count(events, EventKind::kPossible);
      test::take_all(swarm, time_s, events);
      if (count(events, EventKind::kPossible) > before) reported_s = time_s;
    }
    const Events possible = test::of_kind(events, EventKind::kPossible);
    ASSERT_EQ(possible.size(), 1U) << "once a silence";
    // One bee alone, just before the other is heard again at its place.
    EXPECT_EQ(reported_s, both ? 4.0 : 7.75);
    EXPECT_NEAR(possible[0].time_s, both ? 4.0 : 7.75, 1e-9);
    EXPECT_EQ(possible[0].first, 1U);
    EXPECT_EQ(possible[0].second, 2U);
    EXPECT_EQ(possible[0].distance_m, 100.0);
    EXPECT_EQ(possible[0].since_s, 0.0);
  }
}

TEST(SwarmPossible, ComesAgainInAnotherSilence) {
  SwarmOptions options = options_with();
  options.max_speed_mps = 10.0;
  Swarm swarm(options);
  Events events;
  for (double time_s = 0.0; time_s <= 40.0; time_s += 0.5) {
    hear(swarm, 2, time_s, 100.0);
    if (time_s == 0.0 || time_s == 20.0) hear(swarm, 1, time_s, 0.0);
    test::take_all(swarm, time_s, events);
  }
  EXPECT_EQ(count(events, EventKind::kPossible), 2U);
  EXPECT_EQ(count(events, EventKind::kHeard), 1U);
  swarm.remove(1);
  hear(swarm, 3, 40.0, 0.0);
  test::take_all(swarm, 40.0, events);
  EXPECT_EQ(count(events, EventKind::kPossible), 2U);
}

TEST(SwarmPossible, IsOfCylindersToo) {
  for (const bool apart : {false, true}) {
    SwarmOptions options = options_with();
    options.max_speed_mps = 1.0;
    options.vertical_m = 5.0;
    options.heights_apart = apart;
    Swarm swarm(options);
    const auto tell = [&](AgentId id, double time_s, double height) {
      const Point at{0, 0, apart ? 0.0 : height};
      ASSERT_TRUE(swarm.update({id, time_s, at, {}, apart ? height : 0.0, 0.0}).has_value());
    };
    tell(1, 0.0, 0.0);
    Events events;
    for (double time_s = 0.0; time_s <= 30.0; time_s += 1.0) {
      tell(2, time_s, 25.0);
      test::take_all(swarm, time_s, events);
    }
    const Events possible = test::of_kind(events, EventKind::kPossible);
    ASSERT_EQ(possible.size(), 1U);
    EXPECT_NEAR(possible[0].time_s, 19.0, 1e-9) << "20 m to bridge, 1 m by the other one";
    EXPECT_EQ(possible[0].distance_m, 25.0);
  }
}

// Positions before and after a loss are not connected, however soon the bee is heard again.
TEST(SwarmSilence, OfABeeThatIsLostBeginsWithItsLastReport) {
  SwarmOptions options = options_with();
  Swarm swarm(options);
  Events events;
  swarm.lose(1);  // not known yet
  hear(swarm, 1, 0.0, -100.0);
  hear(swarm, 2, 0.0, 0.0);
  swarm.lose(1);
  swarm.lose(1);
  hear(swarm, 1, 1.0, 100.0);
  hear(swarm, 2, 1.0, 0.0);
  test::take_all(swarm, 1.0, events);
  EXPECT_EQ(count(events, EventKind::kEntered), 0U) << "it went past 2 on a line";
  EXPECT_EQ(count(events, EventKind::kStale), 1U);
  EXPECT_EQ(count(events, EventKind::kHeard), 1U);
  EXPECT_EQ(swarm.silences(1.0), (std::vector<Silence>{{1, 1.0, {}}}));
  swarm.lose(1);
  test::take_all(swarm, 1.0, events);
  EXPECT_EQ(count(events, EventKind::kStale), 2U) << "and is reported while it lasts";
  EXPECT_EQ(swarm.counts().stale, 1U);
}

TEST(SwarmSilence, LastsWhenTimesBeginAnew) {
  SwarmOptions options = options_with();
  options.horizon_s = 0.0;
  Swarm swarm(options);
  Events events;
  hear(swarm, 1, 90.0, -100.0);
  hear(swarm, 2, 100.0, 0.0);
  hear(swarm, 3, 100.0, 500.0);
  test::take_all(swarm, 100.0, events);
  EXPECT_EQ(count(events, EventKind::kStale), 1U);
  ASSERT_TRUE(swarm.begin_anew(100.0, 0.0).has_value());
  EXPECT_EQ(swarm.counts().stale, 1U);
  EXPECT_EQ(swarm.counts().agents, 2U);
  EXPECT_EQ(swarm.silences(1.0), (std::vector<Silence>{{1, 11.0, -10.0}}));
  hear(swarm, 2, 0.0, 0.0);
  hear(swarm, 2, 10.0, 0.0);
  events.clear();
  test::take_all(swarm, 10.0, events);
  // 3 has not been heard of since; 2 was silent, too.
  EXPECT_EQ(count(events, EventKind::kStale), 2U);
  EXPECT_EQ(swarm.counts().stale, 2U);
  hear(swarm, 1, 11.0, -100.0);
  hear(swarm, 3, 11.0, 500.0);
  events.clear();
  test::take_all(swarm, 11.0, events);
  EXPECT_EQ(count(events, EventKind::kHeard), 2U);
  EXPECT_EQ(swarm.counts().stale, 0U);
}

// Both fall silent and are heard again before, or between, two calls.
TEST(SwarmPossible, IsTheSameHoweverOftenEventsAreAskedFor) {
  test::SceneMaker make(78);
  for (int round = 0; round < 40; ++round) {
    std::vector<PositionReport> reports;
    for (AgentId id = 0; id < 6; ++id) {
      Point at{make.between(0, 300), make.between(0, 300), 0};
      for (double time_s = make.between(0, 1); time_s < 40.0;) {
        reports.push_back({id, time_s, at});
        const double lasts_s = make.below(5) == 0 ? make.between(3, 9) : make.between(0.2, 2);
        at.x += make.between(-7, 7) * lasts_s;
        at.y += make.between(-7, 7) * lasts_s;
        time_s += lasts_s;
      }
    }
    std::sort(reports.begin(), reports.end(),
              [](const PositionReport& a, const PositionReport& b) { return a.time_s < b.time_s; });
    std::vector<Events> runs;
    for (const double every_s : {0.01, 0.5, 7.0, 100.0}) {
      SwarmOptions options = options_with();
      options.max_speed_mps = 10.0;
      Swarm swarm(options);
      Events events;
      double look_s = 0.0;
      for (const PositionReport& report : reports) {
        for (; look_s < report.time_s; look_s += every_s) test::take_all(swarm, look_s, events);
        ASSERT_TRUE(swarm.update(report).has_value());
      }
      test::take_all(swarm, 108.0, events);
      Events possible = test::of_kind(events, EventKind::kPossible);
      std::sort(possible.begin(), possible.end(), [](const SwarmEvent& a, const SwarmEvent& b) {
        return std::tie(a.time_s, a.first, a.second) < std::tie(b.time_s, b.first, b.second);
      });
      runs.push_back(possible);
    }
    EXPECT_GT(runs[0].size(), 5U);
    for (const Events& other : runs) EXPECT_EQ(other, runs[0]) << "round " << round;
  }
}

// No possible conflict is missed: bees fly as fast as they may, in any direction, some of them
// silent for a while.
TEST(SwarmPossible, MissesNothingThatHappensUnseen) {
  test::SceneMaker make(77);
  std::size_t unseen = 0;
  for (int round = 0; round < 40; ++round) {
    SwarmOptions options = options_with();
    options.max_speed_mps = 10.0;
    Swarm swarm(options);
    std::vector<Point> at;
    std::vector<double> heard_s(8, 0.0);
    std::vector<bool> silent(8, false);
    for (int i = 0; i < 8; ++i) {
      at.push_back({make.between(0, 150), make.between(0, 150), make.between(0, 20)});
    }
    std::vector<std::vector<bool>> possible(8, std::vector<bool>(8, false));
    for (int step = 0; step <= 80; ++step) {
      const double time_s = 0.25 * step;
      for (AgentId i = 0; i < 8; ++i) {
        if (step > 0) {
          const double angle = make.between(0, 6.28);
          at[i].x += 2.49 * std::cos(angle);
          at[i].y += 2.49 * std::sin(angle);
        }
        if (make.below(30) == 0) silent[i] = !silent[i];
        if (step == 0 || !silent[i]) {
          ASSERT_TRUE(swarm.update({i, time_s, at[i]}).has_value());
          if (time_s - heard_s[i] > options.max_age_s) {
            for (AgentId j = 0; j < 8; ++j) possible[i][j] = possible[j][i] = false;
          }
          heard_s[i] = time_s;
        }
      }
      const auto events = swarm.advance(time_s);
      ASSERT_TRUE(events.has_value());
      for (const SwarmEvent& event : *events) {
        if (event.kind == EventKind::kPossible) possible[event.first][event.second] = true;
      }
      for (AgentId i = 0; i < 8; ++i) {
        for (AgentId j = i + 1; j < 8; ++j) {
          const bool stale =
              time_s - heard_s[i] > options.max_age_s || time_s - heard_s[j] > options.max_age_s;
          const double apart = std::hypot(at[i].x - at[j].x, at[i].y - at[j].y, at[i].z - at[j].z);
          if (!stale || apart >= options.threshold_m) continue;
          ++unseen;
          EXPECT_TRUE(possible[i][j]) << i << " and " << j << " at " << time_s;
        }
      }
    }
  }
  EXPECT_GT(unseen, 500U);
}

}  // namespace
}  // namespace beespace
