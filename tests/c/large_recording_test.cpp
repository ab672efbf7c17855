// Recordings beyond memory: C answers as a recording in memory does, under ids that have a sign,
// and refuses what makes no sense.
#include "tests/c/c_scenes.hpp"
#include "tests/support/recording_scenes.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();

const std::string& folder() {
  static const std::string path = std::filesystem::temp_directory_path().string();
  return path;
}

beespace_out_of_core_options least() {
  beespace_out_of_core_options options{};
  options.struct_size = sizeof options;
  options.memory_bytes = std::uint64_t{16} << 20U;
  options.folder = folder().c_str();
  return options;
}

// Fixes in columns of their own.
struct Rows {
  std::vector<std::int64_t> agents;
  std::vector<double> times_s;
  std::vector<Point> positions;
  std::vector<double> heights = {};

  [[nodiscard]] beespace_fixes fixes() const {
    beespace_fixes fixes{};
    fixes.struct_size = sizeof fixes;
    fixes.agents = agents.data();
    fixes.times_s = times_s.data();
    fixes.agents_stride = fixes.times_stride = fixes.heights_stride = 8;
    if (!heights.empty()) fixes.heights_m = heights.data();
    return fixes;
  }
};

// Some ids are below zero, and rows stand from the last to the first.
std::int64_t id_of(PointId track) {
  return std::int64_t{track} * 3 - 40;
}

Rows rows_of(const Tracks& tracks) {
  Rows rows;
  for (std::size_t track = tracks.size(); track-- > 0;) {
    for (std::size_t at = tracks[track].fixes.size(); at-- > 0;) {
      rows.agents.push_back(id_of(static_cast<PointId>(track)));
      rows.times_s.push_back(tracks[track].fixes[at].time_s);
      rows.positions.push_back(tracks[track].fixes[at].position);
      if (!tracks[track].heights_m.empty()) rows.heights.push_back(tracks[track].heights_m[at]);
    }
  }
  return rows;
}

// What visitors have seen.
struct Seen {
  Numbers ids;
  std::vector<double> numbers;
  Numbers gap_agents;
  std::vector<double> gap_times_s;
  int answer = 1;
};

int see_conflicts(void* data, const std::int64_t* first, const std::int64_t* second,
                  const double* begins_s, const double* closest_s, const double* ends_s,
                  const double* distances_m, std::int64_t count) {
  auto& seen = *static_cast<Seen*>(data);
  for (std::int64_t i = 0; i < count; ++i) {
    seen.ids.insert(seen.ids.end(), {first[i], second[i]});
    seen.numbers.insert(seen.numbers.end(), {begins_s[i], closest_s[i], ends_s[i], distances_m[i]});
  }
  return seen.answer;
}

int see_gaps(void* data, const std::int64_t* agents, const double* begins_s, const double* ends_s,
             std::int64_t count) {
  auto& seen = *static_cast<Seen*>(data);
  for (std::int64_t i = 0; i < count; ++i) {
    seen.gap_agents.push_back(agents[i]);
    seen.gap_times_s.insert(seen.gap_times_s.end(), {begins_s[i], ends_s[i]});
  }
  return seen.answer;
}

class CLargeRecording : public testing::Test {
 protected:
  void make(double height_unit_m = 0.0) {
    beespace_out_of_core_options options = least();
    options.height_unit_m = height_unit_m;
    beespace_large_recording* made = nullptr;
    ASSERT_EQ(beespace_large_recording_create(&options, &made, &error_), BEESPACE_OK);
    recording_.reset(made);
  }
  beespace_code add(const Rows& rows) {
    const beespace_fixes fixes = rows.fixes();
    const beespace_points points = c_points(rows.positions);
    return beespace_large_recording_add(recording_.get(), &fixes, &points, &error_);
  }
  beespace_code ask(const beespace_search& search, double max_gap_s) {
    seen_ = {{}, {}, {}, {}, seen_.answer};
    return beespace_large_recording_conflicts(recording_.get(), &search, max_gap_s, nullptr,
                                              see_conflicts, see_gaps, &seen_, &error_);
  }

  Owned<beespace_large_recording> recording_;
  Seen seen_;
  beespace_error error_ = c_error();
};

TEST_F(CLargeRecording, AnswersAsARecordingInMemory) {
  for (const RecordingScene& scene : recording_scenes()) {
    for (const Shape shape : {Shape::kSphere, Shape::kHeightsApart}) {
      Tracks tracks = scene.of(shape);
      for (Track& track : tracks) track.tolerance_m = 0.0;
      const Rows rows = rows_of(tracks);
      ConflictOptions options = scene.options(shape, true);
      options.height_unit_m = rows.heights.empty() ? 1.0 : 0.3048;
      make(rows.heights.empty() ? 0.0 : 0.3048);
      ASSERT_EQ(add(rows), BEESPACE_OK) << error_.message;
      EXPECT_EQ(beespace_large_recording_size(recording_.get()),
                static_cast<std::int64_t>(rows.agents.size()));
      beespace_search search = c_search(options.threshold_m, BEESPACE_INCLUSIVE);
      if (options.vertical_m) search.flags |= BEESPACE_VERTICAL;
      search.vertical_m = options.vertical_m.value_or(0.0);
      ASSERT_EQ(ask(search, scene.max_gap_s), BEESPACE_OK) << scene.name << error_.message;

      const auto found = *brute_force::find_conflicts(tracks, options);
      Seen expected;
      for (const Conflict& c : found.conflicts) {
        expected.ids.insert(expected.ids.end(), {id_of(c.first), id_of(c.second)});
        expected.numbers.insert(expected.numbers.end(),
                                {c.begins_s, c.closest_s, c.ends_s, c.closest_m});
      }
      for (const Gap& gap : found.gaps) {
        expected.gap_agents.push_back(id_of(gap.track));
        expected.gap_times_s.insert(expected.gap_times_s.end(), {gap.begins_s, gap.ends_s});
      }
      EXPECT_EQ(seen_.ids, expected.ids) << scene.name;
      EXPECT_EQ(seen_.numbers, expected.numbers) << scene.name;
      EXPECT_EQ(seen_.gap_agents, expected.gap_agents) << scene.name;
      EXPECT_EQ(seen_.gap_times_s, expected.gap_times_s) << scene.name;
    }
  }
}

TEST_F(CLargeRecording, AVisitorMayEndItAndFactsAreTold) {
  make();
  ASSERT_EQ(add(rows_of(turning_tracks(1))), BEESPACE_OK);
  seen_.answer = 0;
  EXPECT_EQ(ask(c_search(9.0), kEver), BEESPACE_OK);
  EXPECT_FALSE(seen_.ids.empty());
  seen_.answer = 1;
  EXPECT_EQ(ask(c_search(9.0), kEver), BEESPACE_OK);
  beespace_large_recording_facts facts{};
  facts.struct_size = sizeof facts;
  ASSERT_EQ(beespace_large_recording_facts_of(recording_.get(), &facts, &error_), BEESPACE_OK);
  EXPECT_EQ(facts.windows, 1);
  EXPECT_EQ(facts.copies, 0);
  EXPECT_EQ(facts.encounters, 1);
  EXPECT_EQ(facts.largest_window, beespace_large_recording_size(recording_.get()));
}

TEST_F(CLargeRecording, RefusesWhatMakesNoSense) {
  beespace_large_recording* made = nullptr;
  beespace_out_of_core_options options = least();
  options.memory_bytes = 5;
  EXPECT_EQ(beespace_large_recording_create(&options, &made, &error_), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_large_recording_create(nullptr, &made, &error_), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(made, nullptr);
  EXPECT_EQ(beespace_large_recording_size(nullptr), 0);
  EXPECT_EQ(add({{1}, {0.0}, {{0, 0, 0}}}), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(ask(c_search(5.0), kEver), BEESPACE_INVALID_ARGUMENT);

  make();
  EXPECT_EQ(add({{1, 1}, {0.0, std::nan("")}, {{0, 0, 0}, {1, 0, 0}}}), BEESPACE_NOT_FINITE);
  EXPECT_EQ(error_.record, 1);
  EXPECT_STREQ(error_.place, "times");
  EXPECT_EQ(add({{1}, {0.0}, {{0, 1e31, 0}}}), BEESPACE_OUTSIDE_DOMAIN);
  EXPECT_STREQ(error_.place, "positions");
  Rows rows{{1, 1, 1}, {0.0, 1.0, 0.0}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}};
  beespace_fixes climbing = rows.fixes();
  climbing.climbs_mps = rows.times_s.data();
  climbing.climbs_stride = 8;
  const beespace_points points = c_points(rows.positions);
  EXPECT_EQ(beespace_large_recording_add(recording_.get(), &climbing, &points, &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_large_recording_size(recording_.get()), 0);
  ASSERT_EQ(add(rows), BEESPACE_OK);
  EXPECT_EQ(ask(c_search(5.0), kEver), BEESPACE_TIME_ORDER);
  EXPECT_EQ(error_.record, 2);
  EXPECT_EQ(ask(c_search(5.0), 0.0), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(ask(c_search(-5.0), kEver), BEESPACE_INVALID_THRESHOLD);
  // Gaps must be seen where there may be some.
  const beespace_search search = c_search(5.0);
  EXPECT_EQ(beespace_large_recording_conflicts(recording_.get(), &search, 2.0, nullptr,
                                               see_conflicts, nullptr, &seen_, &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_large_recording_conflicts(recording_.get(), &search, 2.0, nullptr, nullptr,
                                               see_gaps, &seen_, &error_),
            BEESPACE_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace beespace::test
