// Recordings of C: rows in any order of agents become the tracks that they are; conflicts and gaps
// are those of brute force, under the ids of the caller; and rows that cannot be are named.
#include "tests/c/c_scenes.hpp"
#include "tests/support/recording_scenes.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

struct FreeRecording {
  void operator()(beespace_recording* recording) const { beespace_recording_free(recording); }
};
using OwnedRecording = std::unique_ptr<beespace_recording, FreeRecording>;

// As a program may hold them.
struct Row {
  std::int64_t agent;
  double time_s;
  Point position;
  double height = 0.0;
};

struct CRows {
  explicit CRows(const std::vector<Row>& rows, bool heights_apart = false) {
    constexpr auto kStride = static_cast<std::ptrdiff_t>(sizeof(Row));
    fixes.struct_size = sizeof fixes;
    positions.struct_size = sizeof positions;
    if (rows.empty()) return;
    const Row& first = rows.front();
    fixes = {
        sizeof fixes, 0, &first.agent, &first.time_s, kStride, kStride, nullptr, nullptr, 0, 0, 0};
    if (heights_apart) {
      fixes.heights_m = &first.height;
      fixes.heights_stride = kStride;
    }
    positions = {sizeof positions,
                 BEESPACE_FLOAT64,
                 0,
                 static_cast<std::int64_t>(rows.size()),
                 &first.position.x,
                 &first.position.y,
                 &first.position.z,
                 kStride,
                 kStride,
                 kStride};
  }
  beespace_fixes fixes{};
  beespace_points positions{};
};

// Ids that are neither dense nor in the order in which agents appear.
std::int64_t id_of_track(std::size_t track) {
  return static_cast<std::int64_t>((track + 1) * 7919 % 10'007) - 5'000;
}

// One fix of each agent, then the next of each.
std::vector<Row> rows_of(const Tracks& tracks) {
  std::vector<Row> rows;
  bool more = true;
  for (std::size_t i = 0; more; ++i) {
    more = false;
    for (std::size_t track = 0; track < tracks.size(); ++track) {
      const auto& fixes = tracks[track].fixes;
      if (i >= fixes.size()) continue;
      const auto& heights_m = tracks[track].heights_m;
      rows.push_back({id_of_track(track), fixes[i].time_s, fixes[i].position,
                      heights_m.empty() ? 0.0 : heights_m[i]});
      more = true;
    }
  }
  return rows;
}

// Those that have fixes, in the order of their ids.
struct NamedTracks {
  std::vector<std::int64_t> ids;
  Tracks tracks;
};

NamedTracks named(const Tracks& tracks) {
  std::vector<std::size_t> order;
  for (std::size_t track = 0; track < tracks.size(); ++track) {
    if (!tracks[track].fixes.empty()) order.push_back(track);
  }
  std::sort(order.begin(), order.end(),
            [](std::size_t a, std::size_t b) { return id_of_track(a) < id_of_track(b); });
  NamedTracks all;
  for (const std::size_t track : order) {
    all.ids.push_back(id_of_track(track));
    all.tracks.push_back(tracks[track]);
    all.tracks.back().tolerance_m = 0.0;  // which C does not know
  }
  return all;
}

// What an answer says, with ids of agents.
struct Told {
  Numbers ids;
  std::vector<double> times_and_distances;
  Numbers gap_agents;
  std::vector<double> gap_times_s;

  friend bool operator==(const Told&, const Told&) = default;
};

Told told(const std::vector<Conflict>& conflicts, const std::vector<Gap>& gaps,
          const std::vector<std::int64_t>& ids) {
  Told all;
  for (const Conflict& each : conflicts) {
    all.ids.insert(all.ids.end(), {ids[each.first], ids[each.second]});
    all.times_and_distances.insert(all.times_and_distances.end(),
                                   {each.begins_s, each.closest_s, each.ends_s, each.closest_m});
  }
  for (const Gap& gap : gaps) {
    all.gap_agents.push_back(ids[gap.track]);
    all.gap_times_s.insert(all.gap_times_s.end(), {gap.begins_s, gap.ends_s});
  }
  return all;
}

Told told(const beespace_result* from) {
  Told all;
  for (std::int64_t i = 0; i < beespace_result_size(from); ++i) {
    all.ids.insert(all.ids.end(),
                   {beespace_result_first(from)[i], beespace_result_second(from)[i]});
    all.times_and_distances.insert(
        all.times_and_distances.end(),
        {beespace_result_begins_s(from)[i], beespace_result_closest_s(from)[i],
         beespace_result_ends_s(from)[i], beespace_result_distances_m(from)[i]});
  }
  for (std::int64_t i = 0; i < beespace_result_gaps(from); ++i) {
    all.gap_agents.push_back(beespace_result_gap_agents(from)[i]);
    all.gap_times_s.insert(all.gap_times_s.end(), {beespace_result_gap_begins_s(from)[i],
                                                   beespace_result_gap_ends_s(from)[i]});
  }
  return all;
}

// With heights apart these are in feet.
OwnedRecording recording_of(const std::vector<Row>& rows, bool heights_apart = false) {
  CRows given(rows, heights_apart);
  if (heights_apart) given.fixes.height_unit_m = 0.3048;
  beespace_recording* recording = nullptr;
  beespace_error error = c_error();
  EXPECT_EQ(beespace_recording_create(&given.fixes, &given.positions, nullptr, &recording, &error),
            BEESPACE_OK)
      << error.message;
  return OwnedRecording(recording);
}

class CRecordings : public testing::TestWithParam<RecordingScene> {
 protected:
  Owned<beespace_result> result_{beespace_result_create()};
};

TEST_P(CRecordings, ConflictsAndGapsAreThoseOfBruteForce) {
  const RecordingScene& scene = GetParam();
  const NamedTracks expected = named(scene.tracks);
  const OwnedRecording recording = recording_of(rows_of(scene.tracks));
  EXPECT_EQ(beespace_recording_agents(recording.get()),
            static_cast<std::int64_t>(expected.ids.size()));
  for (const Shape shape : {Shape::kSphere, Shape::kCylinder}) {
    for (const bool inclusive : {false, true}) {
      const ConflictOptions options = scene.options(shape, inclusive);
      beespace_search search = c_search(options.threshold_m);
      if (inclusive) search.flags |= BEESPACE_INCLUSIVE;
      if (options.vertical_m) search.flags |= BEESPACE_VERTICAL;
      search.vertical_m = options.vertical_m.value_or(0.0);
      beespace_error error = c_error();
      ASSERT_EQ(beespace_recording_conflicts(recording.get(), &search, scene.max_gap_s, nullptr,
                                             result_.get(), &error),
                BEESPACE_OK)
          << error.message;
      const auto found = *brute_force::find_conflicts(expected.tracks, options);
      EXPECT_EQ(told(result_.get()), told(found.conflicts, found.gaps, expected.ids));
    }
  }
}

TEST_P(CRecordings, HeightsApartAreComparedAsTheyAre) {
  const RecordingScene& scene = GetParam();
  const NamedTracks expected = named(scene.of(Shape::kHeightsApart));
  const OwnedRecording recording = recording_of(rows_of(scene.of(Shape::kHeightsApart)), true);
  ConflictOptions options = scene.options(Shape::kHeightsApart, false);
  options.height_unit_m = 0.3048;
  beespace_search search = c_search(options.threshold_m, BEESPACE_VERTICAL);
  search.vertical_m = *options.vertical_m;
  ASSERT_EQ(beespace_recording_conflicts(recording.get(), &search, scene.max_gap_s, nullptr,
                                         result_.get(), nullptr),
            BEESPACE_OK);
  const auto found = *brute_force::find_conflicts(expected.tracks, options);
  EXPECT_EQ(told(result_.get()), told(found.conflicts, found.gaps, expected.ids));
}

TEST_P(CRecordings, TheClosestTwoAreThoseOfTheLibrary) {
  const RecordingScene& scene = GetParam();
  const NamedTracks expected = named(scene.tracks);
  const OwnedRecording recording = recording_of(rows_of(scene.tracks));
  beespace_run two{};
  two.struct_size = sizeof two;
  two.threads = 2;
  ASSERT_EQ(
      beespace_recording_closest(recording.get(), scene.max_gap_s, &two, result_.get(), nullptr),
      BEESPACE_OK);
  const auto closest = *find_closest_encounter(expected.tracks, scene.max_gap_s);
  const auto all =
      brute_force::find_conflicts(expected.tracks, scene.options(Shape::kSphere, false));
  std::vector<Conflict> conflicts;
  if (closest) conflicts.push_back(*closest);
  EXPECT_EQ(told(result_.get()), told(conflicts, all->gaps, expected.ids));
}

INSTANTIATE_TEST_SUITE_P(Scenes, CRecordings, testing::ValuesIn(recording_scenes()),
                         [](const auto& scene) { return scene.param.name; });

class CRecordingArguments : public testing::Test {
 protected:
  void expect_refused(beespace_code code, const std::string& place, std::int64_t record = -1) {
    expect_refused(CRows(rows_), code, place, record);
  }
  void expect_refused(const CRows& given, beespace_code code, const std::string& place,
                      std::int64_t record = -1) {
    auto* recording = reinterpret_cast<beespace_recording*>(this);
    error_ = c_error();
    EXPECT_EQ(
        beespace_recording_create(&given.fixes, &given.positions, nullptr, &recording, &error_),
        code)
        << error_.message;
    EXPECT_EQ(recording, nullptr);
    EXPECT_EQ(error_.place, place) << error_.message;
    EXPECT_EQ(error_.record, record) << error_.message;
  }
  beespace_code ask(const OwnedRecording& recording, double max_gap_s) {
    return beespace_recording_conflicts(recording.get(), &search_, max_gap_s, run_, result_.get(),
                                        &error_);
  }

  // Past each other at 3 m after 5 s; agent 7 is not heard of for 4 s then.
  std::vector<Row> rows_ = {{7, 0, {0, 0, 0}},   {-2, 0, {10, 3, 0}}, {7, 3, {3, 0, 0}},
                            {-2, 10, {0, 3, 0}}, {7, 7, {7, 0, 0}},   {7, 10, {10, 0, 0}}};
  beespace_search search_ = c_search(3.5);
  const beespace_run* run_ = nullptr;
  beespace_error error_ = c_error();
  Owned<beespace_result> result_{beespace_result_create()};
};

TEST_F(CRecordingArguments, WhatHappensInAGapIsUnknownAndSaidSo) {
  const OwnedRecording recording = recording_of(rows_);
  ASSERT_EQ(ask(recording, INFINITY), BEESPACE_OK) << error_.message;
  const Told all = told(result_.get());
  EXPECT_EQ(all.ids, (Numbers{-2, 7}));
  EXPECT_EQ(all.times_and_distances[1], 5.0);
  EXPECT_EQ(all.times_and_distances[3], 3.0);
  EXPECT_EQ(beespace_result_gaps(result_.get()), 0);
  // The other agent has a gap of 10 s, which is bridged at exactly that.
  ASSERT_EQ(ask(recording, 10.0), BEESPACE_OK);
  EXPECT_EQ(told(result_.get()), all);
  ASSERT_EQ(ask(recording, std::nextafter(10.0, 0.0)), BEESPACE_OK);
  EXPECT_EQ(told(result_.get()), (Told{{}, {}, {-2}, {0, 10}}));
  ASSERT_EQ(ask(recording, 3.5), BEESPACE_OK);
  EXPECT_EQ(told(result_.get()), (Told{{}, {}, {-2, 7}, {0, 10, 3, 7}}));
  // Of the closest two, too: where one is unknown all the time, there is none.
  ASSERT_EQ(beespace_recording_closest(recording.get(), 3.5, nullptr, result_.get(), nullptr),
            BEESPACE_OK);
  const Told closest = told(result_.get());
  EXPECT_EQ(closest.gap_agents, (Numbers{-2, 7}));
  EXPECT_EQ(closest.times_and_distances[1], 0.0);
}

TEST_F(CRecordingArguments, RowsThatCannotBeAreNamed) {
  rows_[4].time_s = 2.0;
  expect_refused(BEESPACE_TIME_ORDER, "times", 4);
  rows_[4].time_s = 3.0;  // twice
  expect_refused(BEESPACE_TIME_ORDER, "times", 4);
  rows_[2].time_s = 0x1p-200;  // as good as 0, at which there is a fix
  expect_refused(BEESPACE_TIME_ORDER, "times", 2);
  rows_[2].time_s = NAN;
  expect_refused(BEESPACE_NOT_FINITE, "times", 2);
  rows_[1].position.y = INFINITY;
  expect_refused(BEESPACE_NOT_FINITE, "positions", 1);
  rows_[0].position.z = -0x1p101;
  expect_refused(BEESPACE_OUTSIDE_DOMAIN, "positions", 0);
}

TEST_F(CRecordingArguments, PointersStridesAndSizesAreChecked) {
  CRows given(rows_);
  given.fixes.agents = nullptr;
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "agents");
  given = CRows(rows_);
  given.fixes.times_stride = 12;
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "times");
  given.fixes.times_stride = std::numeric_limits<std::ptrdiff_t>::min();
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "times");
  given = CRows(rows_);
  given.fixes.agents =
      reinterpret_cast<const std::int64_t*>(reinterpret_cast<const char*>(given.fixes.agents) + 4);
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "agents");
  given = CRows(rows_);
  given.fixes.reserved = 1;
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "fixes");
  given = CRows(rows_);
  given.fixes.struct_size = 8;
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "fixes");
  given = CRows(rows_);
  given.positions.count = -1;
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "positions");
  given = CRows(rows_);
  EXPECT_EQ(beespace_recording_create(&given.fixes, &given.positions, nullptr, nullptr, &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "recording");
  beespace_recording_free(nullptr);
  EXPECT_EQ(beespace_recording_agents(nullptr), 0);
}

TEST_F(CRecordingArguments, QuestionsThatMakeNoSenseAreRefused) {
  const OwnedRecording recording = recording_of(rows_);
  EXPECT_EQ(ask(recording, 0.0), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(ask(recording, NAN), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(ask(nullptr, 1.0), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "recording");
  EXPECT_EQ(beespace_recording_closest(recording.get(), -1.0, nullptr, result_.get(), &error_),
            BEESPACE_INVALID_ARGUMENT);
  search_.threshold_m = -1.0;
  EXPECT_EQ(ask(recording, 1.0), BEESPACE_INVALID_THRESHOLD);
  search_ = c_search(3.5, BEESPACE_MAX_RESULTS);
  EXPECT_EQ(ask(recording, INFINITY), BEESPACE_TOO_MANY_RESULTS);
  EXPECT_EQ(told(result_.get()), Told());
  search_ = c_search(3.5, BEESPACE_DISTANCES);
  EXPECT_EQ(ask(recording, INFINITY), BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CRecordingArguments, HeightsThatMakeNoSenseAreRefused) {
  CRows given(rows_, true);
  given.fixes.climbs_mps = given.fixes.heights_m;
  given.fixes.climbs_stride = given.fixes.heights_stride;
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "climbs");
  for (const double unit_m : {-1.0, 1e31, 0x1p-120, static_cast<double>(NAN)}) {
    given = CRows(rows_, true);
    given.fixes.height_unit_m = unit_m;
    expect_refused(given, BEESPACE_INVALID_ARGUMENT, "heights");
  }
  given = CRows(rows_);
  given.fixes.height_unit_m = 0.3048;
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "heights");
  given = CRows(rows_, true);
  given.fixes.heights_stride = 2;
  expect_refused(given, BEESPACE_INVALID_ARGUMENT, "heights");
  rows_[3].height = NAN;
  expect_refused(CRows(rows_, true), BEESPACE_NOT_FINITE, "heights", 3);
  rows_[3].height = 1e31;
  expect_refused(CRows(rows_, true), BEESPACE_OUTSIDE_DOMAIN, "heights", 3);
  rows_[3].height = 0.0;
  const OwnedRecording recording = recording_of(rows_, true);
  EXPECT_EQ(ask(recording, INFINITY), BEESPACE_INVALID_ARGUMENT);  // without a vertical threshold
  EXPECT_EQ(beespace_recording_closest(recording.get(), 1.0, nullptr, result_.get(), &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "recording");
}

TEST_F(CRecordingArguments, NoFixesAreARecordingOfNoAgents) {
  const OwnedRecording recording = recording_of({});
  EXPECT_EQ(beespace_recording_agents(recording.get()), 0);
  ASSERT_EQ(ask(recording, INFINITY), BEESPACE_OK);
  EXPECT_EQ(told(result_.get()), Told());
}

TEST_F(CRecordingArguments, StopsEndCalls) {
  const OwnedRecording recording = recording_of(rows_);
  const Owned<beespace_stop> stop(beespace_stop_create());
  beespace_stop_request(stop.get());
  beespace_run run{};
  run.struct_size = sizeof run;
  run.stop = stop.get();
  run_ = &run;
  EXPECT_EQ(ask(recording, INFINITY), BEESPACE_STOPPED);
  EXPECT_EQ(beespace_recording_closest(recording.get(), 1.0, &run, result_.get(), &error_),
            BEESPACE_STOPPED);
  const CRows given(rows_);
  beespace_recording* other = nullptr;
  EXPECT_EQ(beespace_recording_create(&given.fixes, &given.positions, &run, &other, &error_),
            BEESPACE_STOPPED);
  EXPECT_EQ(other, nullptr);
}

}  // namespace
}  // namespace beespace::test
