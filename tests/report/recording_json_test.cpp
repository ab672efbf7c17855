// The data of a page agree with the facts of a recording; spans of time are never too short.
#include "report/recording_json.hpp"

#include "tests/report/page_reader.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace beespace::report {
namespace {

using report_test::has;
using report_test::Json;
using report_test::numbers_of;
using report_test::ParsedJson;
using report_test::text_of;
using report_test::values_of;
using test::rounds;
using test::SceneMaker;

std::string json_of(const RecordingFacts& facts, Columns& columns) {
  std::string text;
  io::JsonWriter json(text);
  write_swarm(json, facts, columns);
  return text;
}

// As a page has it.
struct Read {
  explicit Read(const RecordingFacts& facts) : json(json_of(facts, columns)) {}

  Json operator[](std::string_view key) const { return json[key]; }
  [[nodiscard]] std::vector<double> values(Json column) const {
    return values_of(column, columns.elements());
  }
  [[nodiscard]] std::vector<std::uint64_t> numbers(Json column) const {
    return numbers_of(column, columns.elements());
  }
  [[nodiscard]] double begins_s() const { return double(json["time"]["begins_s"]); }
  [[nodiscard]] double tick_s() const { return double(json["fixes"]["time_s"]["scale"]); }

  // As they are drawn, with no heed to gaps.
  [[nodiscard]] std::vector<Track> tracks() const {
    const auto times_s = values(json["fixes"]["time_s"]);
    const auto x = values(json["fixes"]["x"]);
    const auto y = values(json["fixes"]["y"]);
    const auto z = values(json["fixes"]["z"]);
    std::vector<Track> tracks;
    std::size_t next = 0;
    for (const std::uint64_t count : numbers(json["fixes"]["counts"])) {
      Track& track = tracks.emplace_back();
      for (std::uint64_t i = 0; i < count; ++i, ++next) {
        track.fixes.push_back({times_s.at(next), {x.at(next), y.at(next), z.at(next)}});
      }
    }
    EXPECT_EQ(next, times_s.size());
    return tracks;
  }

  Columns columns;
  ParsedJson json;
};

// The rounding error of subtracted and scaled times.
double rounding_s(const Read& read, double lasts_s) {
  return 1e-15 * lasts_s + 4e-16 * std::abs(read.begins_s());
}

void expect_times(const Read& read, const std::vector<Track>& tracks, double error_s) {
  const auto shown = read.tracks();
  ASSERT_EQ(shown.size(), tracks.size());
  for (std::size_t bee = 0; bee < tracks.size(); ++bee) {
    ASSERT_EQ(shown[bee].fixes.size(), tracks[bee].fixes.size());
    for (std::size_t i = 0; i < tracks[bee].fixes.size(); ++i) {
      ASSERT_NEAR(shown[bee].fixes[i].time_s, tracks[bee].fixes[i].time_s - read.begins_s(),
                  error_s);
    }
  }
}

// At the same times, the drawn and the true positions of all bees.
void expect_places(const Read& read, const std::vector<Track>& tracks) {
  const double error_m = double(read["position_error_m"]);
  const auto shown = read.tracks();
  for (std::size_t bee = 0; bee < tracks.size(); ++bee) {
    if (tracks[bee].fixes.size() < 2) continue;
    const double begins_s = tracks[bee].fixes.front().time_s;
    const double lasts_s = tracks[bee].fixes.back().time_s - begins_s;
    for (int share = 0; share <= 200; ++share) {
      const double time_s = begins_s + share / 200.0 * lasts_s;
      const auto there = position_at(tracks[bee], time_s);
      const auto seen = position_at(shown[bee], time_s - read.begins_s());
      if (!there || !seen) continue;
      ASSERT_LE(distance(*there, *seen), error_m * (1.0 + 1e-6) + 1e-9);
    }
  }
}

// Flights of some bees from this time on; regular times are multiples of `every_s`, others at least
// `closest_s` apart.
RecordingFacts flights(SceneMaker& make, double begins_s, double every_s, double speed_mps,
                       double closest_s = 1e-3) {
  RecordingFacts facts;
  for (std::size_t bees = 1 + make.below(6); bees > 0; --bees) {
    Track& track = facts.tracks.emplace_back();
    Point at = make.box(1, {-100, -100, -100}, {100, 100, 100}).front();
    double since_s = every_s > 0.0 ? every_s * static_cast<double>(make.below(50)) : 0.0;
    for (std::size_t count = make.below(60); count > 0; --count) {
      track.fixes.push_back({begins_s + since_s, at});
      const double step_s = every_s > 0.0 ? every_s : closest_s * make.between(1.0, 2e3);
      since_s += step_s;
      const double most_m = speed_mps * step_s;
      at = test::shifted(at, make.box(1, {-most_m, -most_m, 0}, {most_m, most_m, 0}).front());
    }
  }
  return facts;
}

TEST(RecordingJson, RegularTimesAreWrittenAsMilliseconds) {
  SceneMaker make(1);
  for (int round = 0; round < rounds(60); ++round) {
    for (const double begins_s : {0.0, -20.0, 1.7e9}) {
      const RecordingFacts facts = flights(make, begins_s, 0.04, 20.0);
      const Read read(facts);
      EXPECT_EQ(read.tick_s(), 1e-3);
      expect_times(read, facts.tracks, 1e-6);
      expect_places(read, facts.tracks);
    }
  }
}

TEST(RecordingJson, MicrosecondsAreWrittenAsSuch) {
  RecordingFacts facts;
  facts.tracks = {{{{0.000'001, {0, 0, 0}}, {1.234'567, {9, 0, 0}}, {4'000.000'002, {0, 0, 0}}}}};
  const Read read(facts);
  EXPECT_EQ(read.tick_s(), 1e-6);
  expect_times(read, facts.tracks, 1e-9);
}

// From one fix of a bee to its next.
double shortest_step(const std::vector<Track>& tracks) {
  double shortest_s = 1.0;
  for (const Track& track : tracks) {
    for (std::size_t i = 1; i < track.fixes.size(); ++i) {
      shortest_s = std::min(shortest_s, track.fixes[i].time_s - track.fixes[i - 1].time_s);
    }
  }
  return shortest_s;
}

// Times of no rhythm, no closer to each other than this.
void expect_irregular(double closest_s, double begins_s, SceneMaker& make) {
  const RecordingFacts facts = flights(make, begins_s, 0.0, 20.0, closest_s);
  const Read read(facts);
  const double lasts_s = double(read["time"]["ends_s"]) - read.begins_s();
  expect_times(read, facts.tracks, 0.5 * read.tick_s() + rounding_s(read, lasts_s));
  expect_places(read, facts.tracks);
  EXPECT_LE(read.tick_s(), std::max(1e-9, 0.11 * shortest_step(facts.tracks)));
  for (const Track& track : read.tracks()) {
    for (std::size_t i = 1; i < track.fixes.size(); ++i) {
      ASSERT_GT(track.fixes[i].time_s, track.fixes[i - 1].time_s) << "two at the same time";
    }
  }
}

TEST(RecordingJson, IrregularTimesAreWrittenFinelyEnough) {
  SceneMaker make(2);
  for (int round = 0; round < rounds(60); ++round) {
    for (const double begins_s : {0.0, -1e4, 1.7e9}) {
      for (const double closest_s : {1e-5, 1e-3, 0.1}) expect_irregular(closest_s, begins_s, make);
    }
  }
}

TEST(RecordingJson, FastBeesAndCoarseTicksAreInTheStatedError) {
  SceneMaker make(3);
  for (int round = 0; round < rounds(40); ++round) {
    RecordingFacts facts = flights(make, 0.0, 0.0, 300.0);
    // Another bee is heard again years later: ticks are then some hundredths of a second.
    facts.tracks.push_back({{{0.0, {0, 0, 0}}, {2e8 + make.between(0.0, 1.0), {0, 0, 0}}}});
    const Read read(facts);
    EXPECT_GT(read.tick_s(), 0.04);
    expect_places(read, facts.tracks);
  }
}

TEST(RecordingJson, WithExactTimesTheErrorIsThatOfThePositionsOnly) {
  RecordingFacts facts;
  facts.tracks = {{{{0.0, {0, 0, 0}}, {1.0, {1e6, 0, 0}}, {1.5, {2e6, 0, 0}}}}};
  const double half_a_step_m = 0.5 * 2e6 / 65'535.0;
  EXPECT_NEAR(double(Read(facts)["position_error_m"]), half_a_step_m, 1e-6);
  facts.tracks[0].tolerance_m = 100.0;
  EXPECT_NEAR(double(Read(facts)["position_error_m"]), 100.0 + half_a_step_m, 1e-6);
}

TEST(RecordingJson, TheTimeIsThatOfAllFixes) {
  RecordingFacts facts;
  facts.tracks = {{}, {{{5.0, {}}, {7.0, {}}}}, {{{3.0, {}}}}, {{{9.5, {}}}}};
  facts.calendar.since_1970 = true;
  const Read read(facts);
  EXPECT_EQ(text_of(read["kind"]), "recording");
  EXPECT_EQ(std::uint64_t(read["count"]), 4u);
  EXPECT_EQ(read.begins_s(), 3.0);
  EXPECT_EQ(double(read["time"]["ends_s"]), 9.5);
  EXPECT_TRUE(bool(read["time"]["since_1970"]));
  EXPECT_EQ(read.numbers(read["fixes"]["counts"]), (std::vector<std::uint64_t>{0, 2, 1, 1}));
  facts.calendar.since_1970 = false;
  EXPECT_FALSE(bool(Read(facts)["time"]["since_1970"]));
}

TEST(RecordingJson, TheClockSaysByHowMuchItIsAheadAndWhenItIsTurned) {
  constexpr double kBerlinSetBack_s = 1'729'990'800.0;  // 2024-10-27T01:00:00Z
  RecordingFacts facts;
  facts.tracks = {{{{kBerlinSetBack_s - 100.0, {}}, {kBerlinSetBack_s + 100.0, {}}}}};
  facts.calendar = {true, *io::TimeZone::find("Europe/Berlin"), {}};
  const Read berlin(facts);
  const Json clock = berlin["time"]["clock"];
  EXPECT_TRUE(bool(clock["dated"]));
  EXPECT_EQ(text_of(clock["zone"]), "Europe/Berlin");
  const auto numbers = [](Json offsets) {
    std::vector<double> all;
    for (const Json offset : offsets) {
      all.push_back(double(offset["from_s"]));
      all.push_back(double(offset["ahead_s"]));
    }
    return all;
  };
  EXPECT_EQ(numbers(clock["offsets"]), (std::vector<double>{0.0, 7'200.0, 100.0, 3'600.0}));

  facts.calendar = {false, {}, io::WallClock{true, 1'714'521'600}};
  const Read unnamed(facts);
  EXPECT_TRUE(bool(unnamed["time"]["clock"]["dated"]));
  EXPECT_FALSE(has(unnamed["time"]["clock"], "zone"));
  EXPECT_EQ(numbers(unnamed["time"]["clock"]["offsets"]),
            (std::vector<double>{0.0, 1'714'521'600.0}));
  for (const io::Calendar& plain : {io::Calendar{}, io::Calendar{true, {}, {}}}) {
    facts.calendar = plain;
    EXPECT_FALSE(has(Read(facts)["time"], "clock"));
  }
}

TEST(RecordingJson, GapsAreWrittenAsTheFixBeforeThem) {
  RecordingFacts facts;
  facts.tracks = {{{{0, {}}, {1, {}}, {50, {}}}}, {{{0, {}}, {60, {}}}}};
  facts.gaps = {{0, 1.0, 50.0}, {1, 0.0, 60.0}};
  const Read read(facts);
  EXPECT_EQ(read.numbers(read["absent_after"]), (std::vector<std::uint64_t>{1, 3}));
}

TEST(RecordingJson, WhenBeesAreUnknownIsWritten) {
  RecordingFacts facts;
  facts.tracks = {{{{10, {}}, {11, {}}, {60, {}}}}, {{{10, {}}, {40, {}}}}};
  const Read known(facts);
  EXPECT_FALSE(has(known.json.root(), "unknown"));
  EXPECT_FALSE(has(known["separation"], "open"));
  facts.unknown_spans = {{0, 11.0, 60.0}, {1, 40.0, 60.0}};
  facts.separation_open = {{11.5, 20.0}, {30.0, 60.0}};
  const Read read(facts);
  EXPECT_EQ(read.numbers(read["unknown"]["bee"]), (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(read.values(read["unknown"]["ends_s"]), (std::vector<double>{50.0, 50.0}));
  EXPECT_EQ(read.values(read["separation"]["open"]["ends_s"]), (std::vector<double>{10.0, 50.0}));
}

// A recording from `begins_s` on with conflicts now and then.
RecordingFacts with_conflicts(SceneMaker& make, double begins_s, bool regular) {
  RecordingFacts facts = flights(make, begins_s, regular ? 0.5 : 0.0, 5.0);
  const double lasts_s = regular ? 100.0 : 100.0 + make.between(0.0, 1.0);
  facts.tracks.push_back({{{begins_s, {}}, {begins_s + lasts_s, {}}}});
  for (PointId i = 0; i < 40; ++i) {
    const double from_s = make.below(9) == 0 ? 0.0 : make.between(0.0, 50.0);
    const double to_s = make.below(9) == 0 ? lasts_s : from_s + make.between(0.0, 50.0);
    const double closest_s = from_s + make.between(0.0, 1.0) * (to_s - from_s);
    facts.conflicts.push_back({i, i + 1 + static_cast<PointId>(make.below(99)), begins_s + from_s,
                               begins_s + closest_s, begins_s + to_s, 0.1 * i, make.below(2) == 0});
    facts.at_risk.push_back({i / 3, {begins_s + from_s, begins_s + to_s}});
  }
  return facts;
}

// The written span contains the true one, and little more.
void expect_span(const Read& read, double begins_s, double ends_s, const TimeSpan& span) {
  const double from_s = span.begins_s - read.begins_s();
  const double to_s = span.ends_s - read.begins_s();
  const double rounding = rounding_s(read, 101.0);
  ASSERT_LE(begins_s, from_s + rounding);
  ASSERT_GE(begins_s, from_s - read.tick_s() - rounding);
  ASSERT_GE(ends_s, to_s - rounding);
  ASSERT_LE(ends_s, to_s + read.tick_s() + rounding);
}

void expect_conflicts(const Read& read, const std::vector<Conflict>& conflicts) {
  const Json columns = read["conflicts"];
  const auto firsts = read.numbers(columns["first"]);
  const auto seconds = read.numbers(columns["second"]);
  const auto begins_s = read.values(columns["begins_s"]);
  const auto closest_s = read.values(columns["closest_s"]);
  const auto ends_s = read.values(columns["ends_s"]);
  const auto distances_m = read.values(columns["distance_m"]);
  const auto certain = read.numbers(columns["certain"]);
  for (const std::size_t size : {firsts.size(), seconds.size(), begins_s.size(), closest_s.size(),
                                 ends_s.size(), distances_m.size(), certain.size()}) {
    ASSERT_EQ(size, conflicts.size());
  }
  for (std::size_t i = 0; i < conflicts.size(); ++i) {
    EXPECT_EQ(firsts[i], conflicts[i].first);
    EXPECT_EQ(seconds[i], conflicts[i].second);
    EXPECT_EQ(distances_m[i], conflicts[i].closest_m);
    EXPECT_EQ(certain[i], conflicts[i].certain ? 1u : 0u);
    expect_span(read, begins_s[i], ends_s[i], {conflicts[i].begins_s, conflicts[i].ends_s});
    EXPECT_NEAR(closest_s[i], conflicts[i].closest_s - read.begins_s(),
                0.5 * read.tick_s() + rounding_s(read, 101.0));
  }
}

void expect_at_risk(const Read& read, const std::vector<AtRisk>& at_risk) {
  const Json columns = read["at_risk"];
  const auto bees = read.numbers(columns["bee"]);
  const auto begins_s = read.values(columns["begins_s"]);
  const auto ends_s = read.values(columns["ends_s"]);
  ASSERT_EQ(bees.size(), at_risk.size());
  ASSERT_EQ(begins_s.size(), at_risk.size());
  ASSERT_EQ(ends_s.size(), at_risk.size());
  for (std::size_t i = 0; i < at_risk.size(); ++i) {
    EXPECT_EQ(bees[i], at_risk[i].bee);
    expect_span(read, begins_s[i], ends_s[i], at_risk[i].span);
  }
}

TEST(RecordingJson, ConflictsAreWrittenWithTimesRoundedOutward) {
  SceneMaker make(4);
  for (int round = 0; round < rounds(40); ++round) {
    for (const double begins_s : {0.0, -1e3, 1.7e9}) {
      for (const bool regular : {false, true}) {
        const RecordingFacts facts = with_conflicts(make, begins_s, regular);
        const Read read(facts);
        expect_conflicts(read, facts.conflicts);
        expect_at_risk(read, facts.at_risk);
      }
    }
  }
}

TEST(RecordingJson, AConflictOfAnInstantHasABeginningAndAnEnd) {
  RecordingFacts facts;
  facts.tracks = {{{{0, {}}, {10, {}}}}, {{{0, {}}, {10, {}}}}};
  facts.conflicts = {{0, 1, 4.0005, 4.0005, 4.0005, 1.0, true}};
  const Read read(facts);
  EXPECT_EQ(read.numbers(read["conflicts"]["begins_s"]), (std::vector<std::uint64_t>{4'000}));
  EXPECT_EQ(read.numbers(read["conflicts"]["ends_s"]), (std::vector<std::uint64_t>{4'001}));
}

TEST(RecordingJson, TheRiskIsThatOfAll) {
  RecordingFacts facts;
  facts.tracks = {{{{100, {}}, {110, {}}}}};
  facts.conflict_count = 5'000'000'000;
  facts.possible_count = 3;
  facts.pair_count = 2;
  facts.at_risk = {{0, {101, 102}}, {0, {103, 103.5}}, {7, {100, 110}}};
  facts.closest = Conflict{3, 7, 104, 104, 104, 0.1, true};
  const Read read(facts);
  const Json risk = read["risk"];
  EXPECT_EQ(std::uint64_t(risk["conflicts"]), facts.conflict_count);
  EXPECT_EQ(std::uint64_t(risk["possible"]), 3u);
  EXPECT_EQ(std::uint64_t(risk["pairs"]), 2u);
  EXPECT_EQ(std::uint64_t(risk["bees"]), 2u);
  EXPECT_EQ(double(risk["bee_seconds"]), 11.5);
  EXPECT_EQ(std::uint64_t(risk["closest"]["first"]), 3u);
  EXPECT_EQ(std::uint64_t(risk["closest"]["second"]), 7u);
  EXPECT_EQ(double(risk["closest"]["distance_m"]), 0.1);
  EXPECT_EQ(double(risk["closest"]["time_s"]), 4.0);
}

TEST(RecordingJson, TheSeparationIsWrittenExactly) {
  RecordingFacts facts;
  facts.tracks = {{{{100, {}}, {110, {}}}}};
  facts.separation = {{100, {0, 1, 0.1}}, {104.25, {2, 3, 0.0}}, {110, {0, 3, 1e9}}};
  const Read read(facts);
  EXPECT_EQ(read.values(read["separation"]["time_s"]), (std::vector<double>{0, 4.25, 10}));
  EXPECT_EQ(read.values(read["separation"]["distance_m"]), (std::vector<double>{0.1, 0.0, 1e9}));
  EXPECT_EQ(read.numbers(read["separation"]["first"]), (std::vector<std::uint64_t>{0, 2, 0}));
  EXPECT_EQ(read.numbers(read["separation"]["second"]), (std::vector<std::uint64_t>{1, 3, 3}));
}

TEST(RecordingJson, WhatIsHorizontalAndInHeightIsWrittenExactly) {
  RecordingFacts facts;
  facts.tracks = {{{{100, {}}, {110, {}}}}};
  facts.separation = {{100, {0, 1, 5.0}, Apart{3.0, 4.0}}, {104, {0, 1, 0.1}, Apart{0.1, 0.0}}};
  facts.conflicts = {{0, 1, 104, 104, 104, 0.1, true}};
  facts.conflicts_apart = {{0.1, 1e-3}};
  facts.closest = facts.conflicts.front();
  facts.closest_apart = Apart{0.1, 1e-3};
  const Read read(facts);
  EXPECT_EQ(read.values(read["separation"]["horizontal_m"]), (std::vector<double>{3.0, 0.1}));
  EXPECT_EQ(read.values(read["separation"]["height_m"]), (std::vector<double>{4.0, 0.0}));
  EXPECT_EQ(read.values(read["conflicts"]["horizontal_m"]), (std::vector<double>{0.1}));
  EXPECT_EQ(read.values(read["conflicts"]["height_m"]), (std::vector<double>{1e-3}));
  EXPECT_EQ(double(read["risk"]["closest"]["horizontal_m"]), 0.1);
  EXPECT_EQ(double(read["risk"]["closest"]["height_m"]), 1e-3);
}

TEST(RecordingJson, WaysBetweenPairsAreWrittenToAHundredThousandthOfTheThreshold) {
  RecordingFacts facts;
  facts.tracks = {{{{100, {}}, {110, {}}}}};
  facts.swarm.threshold_m = 50.0;
  facts.swarm.origin = GeographicPosition{8.5, 47.0, 0.0};
  facts.pair_ways = {{{101, 102.5}, {{1, 2, 3}, {-4'000.7, 5, 6}}, {{7, 8, 9}, {0, 0, 0}}, {1, -2}},
                     {},
                     {{103}, {{9e5, 0, 0}}, {{1, 1, 1}}, {0.25}}};
  const Read read(facts);
  const Json ways = read["pair_ways"];
  EXPECT_EQ(read.numbers(ways["counts"]), (std::vector<std::uint64_t>{2, 0, 1}));
  EXPECT_EQ(read.values(ways["time_s"]), (std::vector<double>{1.0, 2.5, 3.0}));
  const auto expect_near = [&](const char* name, const std::vector<double>& wanted) {
    const auto found = read.values(ways[name]);
    ASSERT_EQ(found.size(), wanted.size()) << name;
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 5e-4) << name;
  };
  expect_near("x", {1, -4'000.7, 9e5});
  expect_near("y", {2, 5, 0});
  expect_near("z", {3, 6, 0});
  expect_near("ground_x", {7, 0, 1});
  expect_near("ground_z", {9, 0, 1});
  expect_near("height", {1, -2, 0.25});
  facts.swarm.origin.reset();
  EXPECT_FALSE(has(Read(facts)["pair_ways"], "ground_x"));
}

TEST(RecordingJson, HowBentFlightIsShownIsPartOfTheError) {
  RecordingFacts facts;
  facts.tracks = {{{{0, {}}, {10, {100, 0, 0}}}}};
  const double straight_m = double(Read(facts)["position_error_m"]);
  facts.bend_m = 2.5;
  EXPECT_NEAR(double(Read(facts)["position_error_m"]), straight_m + 2.5, 1e-12);
}

TEST(RecordingJson, HeightsInFeetOrByPressureAreSaid) {
  RecordingFacts facts;
  EXPECT_FALSE(has(Read(facts).json.root(), "heights"));
  facts.swarm.heights = {true, true};
  const Read read(facts);
  EXPECT_TRUE(bool(read["heights"]["in_feet"]));
  EXPECT_TRUE(bool(read["heights"]["by_pressure"]));
}

TEST(RecordingJson, WhereMilesAndFeetAreSpokenOfIsSaid) {
  RecordingFacts facts;
  EXPECT_FALSE(has(Read(facts).json.root(), "aviation"));
  facts.swarm.aviation = true;
  const Read read(facts);
  EXPECT_TRUE(bool(read["aviation"]));
  EXPECT_FALSE(has(read.json.root(), "heights"));
}

TEST(RecordingJson, NoBeesAndNoConflictsAreWrittenToo) {
  std::vector<RecordingFacts> all(4);
  all[1].tracks = {{}, {}};
  all[2].tracks = {{{{1.7e9, {1, 2, 3}}}}};                   // for an instant
  all[3].tracks = {{}, {{{7.5, {1, 2, 3}}}}, {{{7.5, {}}}}};  // two of them
  for (const RecordingFacts& facts : all) {
    const Read read(facts);
    EXPECT_EQ(std::uint64_t(read["count"]), facts.tracks.size());
    EXPECT_EQ(read.begins_s(), double(read["time"]["ends_s"]));
    expect_times(read, facts.tracks, 0.0);
    expect_conflicts(read, {});
    expect_at_risk(read, {});
    EXPECT_TRUE(read.values(read["separation"]["time_s"]).empty());
    EXPECT_FALSE(has(read["risk"], "closest"));
    EXPECT_EQ(double(read["risk"]["bee_seconds"]), 0.0);
  }
}

// The page names the time that it is about.
TEST(RecordingJson, UnknownTimesOfEachBeeAreWrittenWhereThereAreAny) {
  RecordingFacts facts;
  facts.tracks = {{{{0.0, {0.0, 0.0, 0.0}}, {9.0, {1.0, 0.0, 0.0}}}}};
  const Read all_known(facts);
  EXPECT_FALSE(has(all_known["risk"], "unknown"));
  facts.unknown = "1 bee unknown for 2 h in all";
  const Read read(facts);
  EXPECT_EQ(text_of(read["risk"]["unknown"]), "1 bee unknown for 2 h in all");
}

}  // namespace
}  // namespace beespace::report
