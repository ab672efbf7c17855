#include "scenes/recorded_flights.hpp"

#include <beespace/find_conflicts.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/scenes/fingerprint.hpp"

namespace beespace::scenes {
namespace {

constexpr Point kBox{1'000.0, 800.0, 120.0};
constexpr Speeds kSpeeds{5.0, 20.0};
constexpr FixTimes kTimes{60.0, 2.0};

std::uint64_t fingerprint(const std::vector<Track>& tracks) {
  Fingerprint fingerprint;
  for (const Track& track : tracks) {
    for (const auto& [time_s, p] : track.fixes) fingerprint.take({time_s, p.x, p.y, p.z});
  }
  return fingerprint.value();
}

std::vector<double> times_of(const Track& track) {
  std::vector<double> times;
  for (const Fix& fix : track.fixes) times.push_back(fix.time_s);
  return times;
}

double distance(const Point& a, const Point& b) {
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double z = b.z - a.z;
  return std::sqrt(x * x + y * y + z * z);
}

void expect_fix_times(const Track& track, const FixTimes& times) {
  ASSERT_GE(track.fixes.size(), 2u);
  EXPECT_EQ(track.fixes.front().time_s, 0.0);
  EXPECT_EQ(track.fixes.back().time_s, times.duration_s);
  const double shortest = std::min(times.duration_s, 0.25 * times.interval_s);
  for (std::size_t i = 1; i < track.fixes.size(); ++i) {
    const double lasts = track.fixes[i].time_s - track.fixes[i - 1].time_s;
    ASSERT_GE(lasts, shortest * (1.0 - 1e-12)) << "before fix " << i;
    ASSERT_LE(lasts, 2.0 * times.interval_s * (1.0 + 1e-12)) << "before fix " << i;
  }
}

TEST(RecordedFlights, TheSameSeedGivesTheseBitsOnEveryMachine) {
  const auto movers = random_flight(200, kBox, kSpeeds, 1);
  EXPECT_EQ(fingerprint(fly(movers, kTimes, 1)), 17'679'697'553'988'096'207u);
  EXPECT_EQ(fingerprint(random_turns(200, kBox, kSpeeds, kTimes, 1)), 3'051'010'351'289'423'481u);
  EXPECT_NE(fingerprint(fly(movers, kTimes, 1)), fingerprint(fly(movers, kTimes, 2)));
  EXPECT_NE(fingerprint(random_turns(9, kBox, kSpeeds, kTimes, 1)),
            fingerprint(random_turns(9, kBox, kSpeeds, kTimes, 2)));
}

TEST(RecordedFlights, FixesAreIrregularAndEveryBeeHasItsOwn) {
  const auto tracks = fly(random_flight(200, kBox, kSpeeds, 2), kTimes);
  ASSERT_EQ(tracks.size(), 200u);
  std::set<double> seen;
  std::size_t fixes = 0;
  for (const Track& track : tracks) {
    expect_fix_times(track, kTimes);
    const auto times = times_of(track);
    seen.insert(times.begin() + 1, times.end() - 1);
    fixes += times.size() - 2;
  }
  EXPECT_EQ(seen.size(), fixes) << "two bees share the time of a fix in between";
  EXPECT_NEAR(static_cast<double>(fixes), 200.0 * 29.5, 100.0);
}

TEST(RecordedFlights, FixesMayBeRegular) {
  const Mover mover{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  const auto times = [&mover](double duration, double interval) {
    return times_of(fly(mover, 0, {duration, interval, true}));
  };
  EXPECT_EQ(times(4.0, 1.0), (std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.0}));
  // What is left over at the end is a piece of its own where it is long enough.
  EXPECT_EQ(times(3.5, 1.0), (std::vector<double>{0.0, 1.0, 2.0, 3.0, 3.5}));
  EXPECT_EQ(times(3.125, 1.0), (std::vector<double>{0.0, 1.0, 2.0, 3.125}));
  EXPECT_EQ(times(0.5, 1.0), (std::vector<double>{0.0, 0.5}));
}

TEST(RecordedFlights, WhateverTheDurationTimesAscend) {
  const Mover mover{{}, {1.0, 0.0, 0.0}};
  for (const double duration : {1e-6, 0.1, 0.24, 0.26, 1.0, 1.3, 1.7, 2.0, 100.0}) {
    for (PointId bee = 0; bee < 100; ++bee) {
      const FixTimes times{duration, 1.0};
      expect_fix_times(fly(mover, bee, times, 3), times);
    }
  }
}

TEST(RecordedFlights, FlightIsStraight) {
  const auto movers = random_flight(200, kBox, kSpeeds, 4);
  const auto tracks = fly(movers, kTimes);
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    const auto& [p, v] = movers[bee];
    EXPECT_EQ(tracks[bee].fixes.front().position, p);
    for (const Fix& fix : tracks[bee].fixes) {
      const Point there{p.x + v.x * fix.time_s, p.y + v.y * fix.time_s, p.z + v.z * fix.time_s};
      ASSERT_NEAR(distance(fix.position, there), 0.0, 1e-12);
    }
  }
}

TEST(RecordedFlights, ABeeFliesAloneAsItDoesAmongOthers) {
  const auto movers = random_flight(5, kBox, kSpeeds, 5);
  const auto tracks = fly(movers, kTimes, 6);
  for (PointId bee = 0; bee < movers.size(); ++bee) {
    EXPECT_EQ(fly(movers[bee], bee, kTimes, 6).fixes, tracks[bee].fixes);
  }
}

TEST(RecordedFlights, ARecordingHasTheEncountersOfItsMovers) {
  const EncounterPlan plan{kSpeeds, 30.0, 60.0, 500.0};
  const Encounters scene = known_encounters(300, plan, 7);
  for (const bool regular : {false, true}) {
    const auto found = find_conflicts(fly(scene.movers, {plan.within_s, 2.0, regular}),
                                      {.threshold_m = plan.clear_m});
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(found->conflicts.size(), scene.encounters.size());
    for (std::size_t i = 0; i < scene.encounters.size(); ++i) {
      const Conflict& conflict = found->conflicts[i];
      const Encounter& truth = scene.encounters[i];
      ASSERT_EQ(conflict.first, truth.first);
      ASSERT_EQ(conflict.second, truth.second);
      ASSERT_NEAR(conflict.closest_m, truth.closest_m, 1e-9);
      // How flat the distance is around its least makes the time less certain than the distance.
      ASSERT_NEAR(conflict.closest_s, truth.closest_s, 1e-6);
    }
  }
}

TEST(RecordedFlights, TurnsKeepTheSpeedsAndChangeTheWayAtEveryFix) {
  const auto tracks = random_turns(200, kBox, kSpeeds, kTimes, 8);
  ASSERT_EQ(tracks.size(), 200u);
  const auto starts = random_flight(200, kBox, kSpeeds, 8);
  for (std::size_t bee = 0; bee < tracks.size(); ++bee) {
    expect_fix_times(tracks[bee], kTimes);
    const auto& fixes = tracks[bee].fixes;
    EXPECT_EQ(fixes.front().position, starts[bee].position);
    Point before;
    for (std::size_t i = 1; i < fixes.size(); ++i) {
      const double lasts = fixes[i].time_s - fixes[i - 1].time_s;
      const double speed = distance(fixes[i].position, fixes[i - 1].position) / lasts;
      ASSERT_GE(speed, kSpeeds.slowest_mps - 1e-9);
      ASSERT_LE(speed, kSpeeds.fastest_mps + 1e-9);
      const Point way{(fixes[i].position.x - fixes[i - 1].position.x) / lasts,
                      (fixes[i].position.y - fixes[i - 1].position.y) / lasts,
                      (fixes[i].position.z - fixes[i - 1].position.z) / lasts};
      ASSERT_GT(distance(way, before), 1e-6) << "no turn at fix " << i - 1;
      before = way;
    }
  }
}

TEST(RecordedFlights, NoBeesAreAnEmptyRecording) {
  EXPECT_TRUE(fly(std::vector<Mover>{}, kTimes).empty());
  EXPECT_TRUE(random_turns(0, kBox, kSpeeds, kTimes, 1).empty());
}

}  // namespace
}  // namespace beespace::scenes
