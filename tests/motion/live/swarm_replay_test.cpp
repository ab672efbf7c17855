// Recordings reported to a swarm: its events are the conflicts that find_conflicts finds, however
// often events are asked for, in any order of the bees, and with any number of threads.
#include "tests/support/swarm_replay.hpp"
#include "tests/support/conflict_printer.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using test::Events;
using test::Shape;

struct Replayed {
  std::string name;
  test::Tracks tracks;
  SwarmOptions options;
};

std::vector<Replayed> replays() {
  std::vector<Replayed> all;
  test::SceneMaker make(1848);
  for (const test::RecordingScene& scene : test::recording_scenes()) {
    const std::string& name = scene.name;
    // Swarms have no tolerances. An empty recording has no events.
    if (name.find("Tolerances") != std::string::npos || name == "Empty") continue;
    if (name == "LatticeOfHugeLengths" || name == "LatticeOfTinyLengths") continue;
    for (const Shape shape : {Shape::kSphere, Shape::kCylinder, Shape::kHeightsApart}) {
      SwarmOptions options;
      options.threshold_m = scene.threshold_m;
      if (shape != Shape::kSphere) options.vertical_m = scene.vertical_m;
      options.heights_apart = shape == Shape::kHeightsApart;
      constexpr double kFactors[] = {1.0, 1.1, 1.5};
      options.leave_factor = kFactors[make.below(3)];
      options.horizon_s = 0.0;
      options.max_age_s = std::min(scene.max_gap_s, name.rfind("Lattice", 0) == 0 ? 2.5 : 3.0);
      all.push_back({name, scene.of(shape), options});
    }
  }
  return all;
}

// The events of each pair, in the order in which they happened.
using ByPair = std::map<std::pair<AgentId, AgentId>, Events>;

ByPair by_pair(const Events& events) {
  ByPair pairs;
  for (const SwarmEvent& event : events) pairs[{event.first, event.second}].push_back(event);
  return pairs;
}

bool within(const SwarmEvent& event, const Conflict& stretch) {
  return event.time_s >= stretch.begins_s - 1e-9 && event.time_s <= stretch.ends_s + 1e-9;
}

// How much farther apart two are at a time than a threshold, by the larger of the two differences
// where there are two thresholds.
double beyond_leaving(const test::Tracks& tracks, const Conflict& stretch,
                      const SwarmOptions& options) {
  const auto height_at = [&](const Track& track) {
    Track heights;
    for (std::size_t i = 0; i < track.fixes.size(); ++i) {
      heights.fixes.push_back({track.fixes[i].time_s, {0, 0, track.heights_m[i]}});
    }
    return position_at(heights, stretch.ends_s, options.max_age_s)->z;
  };
  const Track& first = tracks[stretch.first];
  const Track& second = tracks[stretch.second];
  const Point p = *position_at(first, stretch.ends_s, options.max_age_s);
  const Point q = *position_at(second, stretch.ends_s, options.max_age_s);
  const double leave_m = options.threshold_m * options.leave_factor;
  const bool level = options.vertical_m && !options.heights_apart;
  const double beyond = std::hypot(p.x - q.x, p.y - q.y, level ? 0.0 : p.z - q.z) - leave_m;
  if (!options.vertical_m) return beyond;
  const double rise = options.heights_apart ? height_at(first) - height_at(second) : p.z - q.z;
  return std::max(beyond, std::abs(rise) - *options.vertical_m * options.leave_factor);
}

// Whether they are in conflict up to where what is known of one of the two ends; nothing where they
// leave it about then.
std::optional<bool> is_lost(const test::Tracks& tracks, const Conflict& stretch,
                            const SwarmOptions& options) {
  const double beyond = beyond_leaving(tracks, stretch, options);
  // Times of today resolve no less than a quarter of a microsecond.
  if (std::abs(beyond) <= 1e-5 * (1.0 + options.threshold_m)) return std::nullopt;
  return beyond < 0.0;
}

// What is said of the closest: each is clearly closer than the one before, and the last is nearly
// as close as the two ever were.
void expect_closest(const Events& closest, const Conflict& stretch, const SwarmOptions& options) {
  const double margin = std::max(0.05, options.leave_factor - 1.0) * options.threshold_m;
  ASSERT_FALSE(closest.empty());
  for (std::size_t k = 0; k < closest.size(); ++k) {
    EXPECT_EQ(closest[k].time_s, closest[k].closest_s);
    EXPECT_GE(closest[k].distance_m, stretch.closest_m);
    EXPECT_TRUE(k == 0 || closest[k].distance_m < closest[k - 1].distance_m - margin);
  }
  EXPECT_LE(closest.back().distance_m, stretch.closest_m + margin);
}

// Strictly, two stretches of a pair may touch at an instant; then events there are of either.
bool touches(const Conflict& a, const Conflict& b) {
  return a.first == b.first && a.second == b.second &&
         (std::abs(a.begins_s - b.ends_s) <= 1e-9 || std::abs(b.begins_s - a.ends_s) <= 1e-9) &&
         a != b;
}

bool has(const Events& events, EventKind kind, double time_s) {
  return std::any_of(events.begin(), events.end(), [&](const SwarmEvent& event) {
    return event.kind == kind && std::abs(event.time_s - time_s) <= 1e-9;
  });
}

void expect_encounters(const Events& events, const test::Tracks& tracks,
                       const SwarmOptions& options) {
  ByPair pairs = by_pair(events);
  const auto expected = test::expected_encounters(tracks, options);
  std::size_t left = 0;
  std::size_t silent = 0;
  for (const test::ExpectedEncounter& encounter : expected) {
    const Conflict& stretch = encounter.stretch;
    const double entered_s = encounter.entered_s;
    SCOPED_TRACE(testing::PrintToString(stretch) + ", entered " + std::to_string(entered_s));
    Events of_stretch;
    for (const SwarmEvent& event : pairs[{stretch.first, stretch.second}]) {
      if (within(event, stretch)) of_stretch.push_back(event);
    }
    ASSERT_TRUE(has(of_stretch, EventKind::kEntered, entered_s));
    const std::optional<bool> sure = is_lost(tracks, stretch, options);
    const bool lost = sure.value_or(has(of_stretch, EventKind::kLost, stretch.ends_s));
    ++(lost ? silent : left);
    ASSERT_TRUE(has(of_stretch, lost ? EventKind::kLost : EventKind::kLeft, stretch.ends_s));
    const bool touched = std::any_of(expected.begin(), expected.end(), [&](const auto& other) {
      return touches(other.stretch, stretch);
    });
    if (touched) continue;
    if (!lost) {
      expect_closest(test::of_kind(of_stretch, EventKind::kClosestPassed), stretch, options);
    }
    EXPECT_EQ(test::of_kind(of_stretch, EventKind::kEntered).size(), 1U);
  }
  EXPECT_EQ(test::of_kind(events, EventKind::kEntered).size(), expected.size());
  EXPECT_EQ(test::of_kind(events, EventKind::kLeft).size(), left);
  EXPECT_EQ(test::of_kind(events, EventKind::kLost).size(), silent);
}

TEST(SwarmReplay, ReportsTheConflictsOfTheRecording) {
  std::size_t event_count = 0;
  for (const Replayed& replayed : replays()) {
    SCOPED_TRACE(replayed.name + ", leaving at " + std::to_string(replayed.options.leave_factor));
    const Events events =
        test::happened(test::replay(test::deliveries_of(replayed.tracks), replayed.options, 0.7));
    expect_encounters(events, replayed.tracks, replayed.options);
    event_count += events.size();
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(event_count, 3000U);
}

TEST(SwarmReplay, ReportsTheSameHoweverOftenItIsCalled) {
  for (const Replayed& replayed : replays()) {
    SCOPED_TRACE(replayed.name);
    const auto deliveries = test::deliveries_of(replayed.tracks);
    if (!deliveries.empty() && deliveries.back().arrives_s - deliveries[0].arrives_s > 1000.0) {
      continue;
    }
    const Events seldom = test::happened(test::replay(deliveries, replayed.options, 1e9));
    for (const double every_s : {0.13, 1.0, 4.7}) {
      SCOPED_TRACE(every_s);
      EXPECT_EQ(test::happened(test::replay(deliveries, replayed.options, every_s)), seldom);
    }
  }
}

TEST(SwarmReplay, ReportsTheSameWithAnyNumberOfThreads) {
  const auto tracks = scenes::random_turns(60, {100, 100, 30}, {3, 12}, {12.0, 1.0, false}, 99);
  SwarmOptions options;
  options.threshold_m = 12.0;
  const auto deliveries = test::deliveries_of(tracks);
  const Events alone = test::replay(deliveries, options, 0.5);
  EXPECT_GT(test::of_kind(alone, EventKind::kPredicted).size(), 30U);
  EXPECT_GT(test::of_kind(alone, EventKind::kEntered).size(), 30U);
  for (const unsigned threads : {0U, 2U, 5U}) {
    options.threads = threads;
    EXPECT_EQ(test::replay(deliveries, options, 0.5), alone) << threads;
  }
}

// One bee's messages take longer, and when it is first heard of the others are forgotten where they
// were then: either that is counted, or nothing is missed.
TEST(SwarmReplay, SaysForHowLongItMissesWhoIsHeardOfLate) {
  int missed = 0;
  int differ = 0;
  for (int round = 0; round < 120; ++round) {
    SCOPED_TRACE(round);
    const auto tracks = scenes::random_turns(4, {20, 20, 5}, {3, 12}, {15.0, 1.0, false},
                                             static_cast<std::uint64_t>(round));
    SwarmOptions options;
    options.threshold_m = 8.0;
    options.horizon_s = 0.0;
    options.max_age_s = 7.0;
    const Events in_order = test::happened(test::replay(test::deliveries_of(tracks), options, 1.0));
    const double takes_s = 0.1 * (round % 60);
    const auto late =
        test::deliveries_of(tracks, [&](AgentId id) { return id == 1 ? takes_s : 0.0; });
    SwarmCounts counts;
    const Events told = test::happened(test::replay(late, options, 0.6, &counts));
    if (counts.missed_s > 0.0) ++missed;
    if (told == in_order) continue;
    EXPECT_GT(counts.missed_s, 0.0) << takes_s;
    ++differ;
  }
  EXPECT_GT(missed, differ);
  EXPECT_GT(differ, 0);
}

// Every bee's messages take their own time, up to four seconds.
TEST(SwarmReplay, ReportsTheSameInAnyOrderOfBees) {
  for (int round = 0; round < test::rounds(40); ++round) {
    SCOPED_TRACE(round);
    test::SceneMaker make(static_cast<std::uint32_t>(round));
    auto tracks = scenes::random_turns(20, {80, 80, 20}, {3, 12}, {15.0, 1.0, false},
                                       static_cast<std::uint64_t>(round));
    if (round % 2 == 0) tracks = test::coming_and_going(tracks, make);
    SwarmOptions options;
    options.threshold_m = 12.0;
    options.horizon_s = 0.0;
    options.max_age_s = 7.0;
    const Events in_order = test::happened(test::replay(test::deliveries_of(tracks), options, 1.0));
    const auto late = test::deliveries_of(
        tracks, [&](AgentId id) { return 4.0 * static_cast<double>(id * 37 % 20) / 20.0; });
    EXPECT_EQ(test::happened(test::replay(late, options, 0.6)), in_order);
    expect_encounters(in_order, tracks, options);
  }
}

// Reports of one bee, repeated: older ones and the latest one.
TEST(SwarmReplay, IsNotMisledByLateAndRepeatedReports) {
  test::SceneMaker make(404);
  const auto tracks = scenes::random_turns(20, {80, 80, 20}, {3, 12}, {15.0, 1.0, false}, 5);
  SwarmOptions options;
  options.threshold_m = 12.0;
  const auto deliveries = test::deliveries_of(tracks);
  const Events clean = test::replay(deliveries, options, 1e9);

  Swarm swarm(options);
  std::map<AgentId, std::vector<PositionReport>> heard;
  std::uint64_t repeated = 0;
  std::uint64_t late = 0;
  std::uint64_t contrary = 0;
  for (const auto& [arrives_s, report] : deliveries) {
    ASSERT_TRUE(swarm.update(report).has_value());
    auto& before = heard[report.id];
    if (make.below(2) == 0) {
      ASSERT_TRUE(swarm.update(report).has_value());
      ++repeated;
    }
    if (!before.empty() && make.below(2) == 0) {
      const std::size_t which = make.below(before.size());
      ASSERT_TRUE(swarm.update(before[which]).has_value());
      // The last two are remembered.
      ++(which + 1 == before.size() ? repeated : late);
    }
    PositionReport elsewhere = report;  // the same time, another place
    elsewhere.position.x += 1.0;
    if (make.below(5) == 0) {
      ASSERT_TRUE(swarm.update(elsewhere).has_value());
      ++contrary;
    }
    before.push_back(report);
  }
  EXPECT_EQ(swarm.counts().taken, deliveries.size());
  EXPECT_EQ(swarm.counts().repeated, repeated);
  EXPECT_EQ(swarm.counts().late, late);
  EXPECT_EQ(swarm.counts().contrary, contrary);
  Events events;
  test::take_all(swarm, 15.0 + 2.0 * options.max_age_s, events);
  EXPECT_EQ(test::happened(events), test::happened(clean));
  EXPECT_GT(test::happened(events).size(), 20U);
}

// Reports of a new bee may be older than all that is kept of the others: no event comes twice.
TEST(SwarmReplay, ReportsNothingTwiceWhenABeeIsHeardLate) {
  const auto tracks = scenes::random_turns(20, {80, 80, 20}, {3, 12}, {15.0, 1.0, false}, 6);
  SwarmOptions options;
  options.threshold_m = 12.0;
  options.horizon_s = 0.0;
  options.max_age_s = 1000.0;
  const auto tell = [&](bool with_late_bees) {
    Swarm swarm(options);
    Events events;
    AgentId stranger = 1000;
    for (const auto& [arrives_s, report] : test::deliveries_of(tracks)) {
      EXPECT_TRUE(swarm.update(report).has_value());
      if (report.id % 4 != 0) continue;
      if (with_late_bees) {
        EXPECT_TRUE(swarm.update({stranger++, 0.25, {1e6, 0, 0}}).has_value());
      }
      test::take_all(swarm, arrives_s, events);
    }
    test::take_all(swarm, 3000.0, events);
    std::erase_if(events, [](const SwarmEvent& event) { return event.first >= 1000; });
    std::sort(events.begin(), events.end(), test::earlier);
    return test::happened(events);
  };
  EXPECT_EQ(tell(true), tell(false));
  EXPECT_GT(tell(false).size(), 20U);
}

}  // namespace
}  // namespace beespace
