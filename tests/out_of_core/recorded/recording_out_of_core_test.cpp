// The class RecordingOutOfCore: what it accepts, what it answers, and what it needs.
#include <beespace/recording_out_of_core.hpp>

#include "scenes/random_stream.hpp"
#include "tests/out_of_core/damage.hpp"
#include "tests/out_of_core/recorded/fixes_of_tracks.hpp"
#include "tests/support/process_memory.hpp"
#include "tests/support/recording_scenes.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace beespace {
namespace {

constexpr std::uint64_t kEnough = std::uint64_t{64} << 20U;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

OutOfCoreOptions enough() {
  return {.memory_bytes = kEnough, .folder = std::filesystem::temp_directory_path().string()};
}

Status add(RecordingOutOfCore& to, const test::Fixes& fixes) {
  return to.add(fixes.agents, fixes.times_s, fixes.view());
}

// Two that meet at 5 s.
test::Fixes meeting() {
  return {
      {7, 9, 7, 9}, {0.0, 0.0, 10.0, 10.0}, {{0, 0, 0}, {100, 3, 0}, {100, 0, 0}, {0, 3, 0}}, {}};
}

Status find(RecordingOutOfCore& recording, const ConflictOptions& options,
            std::vector<LargeConflict>& found) {
  return recording.find_conflicts(options, [&](std::span<const LargeConflict> some) {
    found.insert(found.end(), some.begin(), some.end());
  });
}

ErrorCode code_of(RecordingOutOfCore& recording, const ConflictOptions& options) {
  std::vector<LargeConflict> found;
  const auto status = find(recording, options, found);
  EXPECT_FALSE(status);
  EXPECT_TRUE(found.empty());
  return status ? ErrorCode::kReadFailed : status.error().code;
}

TEST(RecordingOutOfCore, AnswersAgainAndTakesMore) {
  RecordingOutOfCore recording(enough());
  std::vector<LargeConflict> found;
  EXPECT_TRUE(find(recording, {.threshold_m = 5.0}, found));
  EXPECT_TRUE(found.empty());
  ASSERT_TRUE(add(recording, meeting()));
  for (int again = 0; again < 2; ++again) {
    found.clear();
    ASSERT_TRUE(find(recording, {.threshold_m = 5.0}, found));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].first, 7U);
    EXPECT_EQ(found[0].second, 9U);
    EXPECT_DOUBLE_EQ(found[0].begins_s, 4.8);
    EXPECT_EQ(found[0].closest_s, 5.0);
    EXPECT_DOUBLE_EQ(found[0].ends_s, 5.2);
    EXPECT_EQ(found[0].closest_m, 3.0);
  }
  EXPECT_TRUE(recording.facts().encounters);
  EXPECT_EQ(recording.facts().windows, 1U);
  ASSERT_TRUE(recording.add(std::vector<AgentId>{8, 8}, std::vector<double>{1.0, 0.0},
                            std::vector<Point>{{0, 3, 0}, {0, 3, 0}}));
  EXPECT_EQ(recording.size(), 6U);
  found.clear();
  ASSERT_TRUE(find(recording, {.threshold_m = 5.0}, found));
  EXPECT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].second, 8U);
}

TEST(RecordingOutOfCore, FixesComeBackByAgentAndTime) {
  RecordingOutOfCore recording(enough());
  const auto fixes_of = [&] {
    std::vector<LargeFix> found;
    const auto status = recording.visit_fixes([&](std::span<const LargeFix> some) {
      EXPECT_FALSE(some.empty());
      found.insert(found.end(), some.begin(), some.end());
    });
    EXPECT_TRUE(status);
    return found;
  };
  EXPECT_TRUE(fixes_of().empty());
  test::Fixes fixes = meeting();
  fixes.heights = {1.5, 2.5, 3.5, 4.5};
  recording.allow_repeated(true);
  ASSERT_TRUE(add(recording, fixes));
  ASSERT_TRUE(add(recording, fixes));
  const std::vector<LargeFix> expected = {{7, {0.0, {0, 0, 0}}, 1.5},
                                          {7, {10.0, {100, 0, 0}}, 3.5},
                                          {9, {0.0, {100, 3, 0}}, 2.5},
                                          {9, {10.0, {0, 3, 0}}, 4.5}};
  EXPECT_EQ(fixes_of(), expected);
  EXPECT_EQ(recording.facts().repeated, 4U);
  // More than come in one call, and backwards.
  for (int at = 5000; at > 0; --at) {
    ASSERT_TRUE(recording.add(std::vector<AgentId>{8}, std::vector<double>{at * 0.5},
                              PointsView(std::vector<Point>{{1.0 * at, 2, 3}})
                                  .with_heights(std::vector<double>{at * 0.25})));
  }
  const auto found = fixes_of();
  ASSERT_EQ(found.size(), 5004U);
  for (int at = 1; at <= 5000; ++at) {
    const LargeFix wanted{8, {at * 0.5, {1.0 * at, 2, 3}}, at * 0.25};
    ASSERT_EQ(found[static_cast<std::size_t>(at) + 1], wanted);
  }
  recording.allow_repeated(false);
  const auto twice = recording.visit_fixes([](std::span<const LargeFix> /*some*/) {});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().code, ErrorCode::kTimeOrder);
}

TEST(RecordingOutOfCore, OptionsThatMakeNoSense) {
  RecordingOutOfCore good(enough());
  ASSERT_TRUE(add(good, meeting()));
  EXPECT_EQ(code_of(good, {}), ErrorCode::kInvalidThreshold);
  EXPECT_EQ(code_of(good, {.threshold_m = -1.0}), ErrorCode::kInvalidThreshold);
  ConflictOptions gap{.threshold_m = 1.0};
  gap.max_gap_s = 0.0;
  EXPECT_EQ(code_of(good, gap), ErrorCode::kInvalidArgument);
  ConflictOptions few{.threshold_m = 5.0};
  few.max_results = 0;
  EXPECT_EQ(code_of(good, few), ErrorCode::kTooManyResults);

  auto options = enough();
  options.memory_bytes = 1 << 20;
  RecordingOutOfCore small(options);
  EXPECT_EQ(add(small, meeting()).error().code, ErrorCode::kInvalidArgument);
  RecordingOutOfCore nowhere({.memory_bytes = kEnough});
  EXPECT_EQ(add(nowhere, meeting()).error().code, ErrorCode::kInvalidArgument);
  auto elsewhere = enough();
  elsewhere.folder = "/no/such/folder";
  RecordingOutOfCore missing(elsewhere);
  ASSERT_TRUE(add(missing, meeting()));  // they wait
  EXPECT_EQ(code_of(missing, {.threshold_m = 1.0}), ErrorCode::kWriteFailed);
  EXPECT_EQ(add(missing, meeting()).error().code, ErrorCode::kWriteFailed);
}

TEST(RecordingOutOfCore, FixesThatAreNone) {
  RecordingOutOfCore recording(enough());
  ASSERT_TRUE(add(recording, meeting()));
  const auto expect_error = [&](const test::Fixes& fixes, ErrorCode code, const char* array) {
    const auto status = add(recording, fixes);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, code);
    EXPECT_EQ(status.error().location.array, array);
    EXPECT_EQ(status.error().location.record, 2U);
    EXPECT_EQ(recording.size(), 4U);
  };
  test::Fixes fixes = meeting();
  fixes.times_s[2] = kNaN;
  expect_error(fixes, ErrorCode::kNotFinite, "times");
  fixes = meeting();
  fixes.positions[2].y = 1e31;
  expect_error(fixes, ErrorCode::kOutsideDomain, "positions");
  fixes = meeting();
  fixes.times_s.pop_back();
  EXPECT_EQ(add(recording, fixes).error().code, ErrorCode::kInvalidArgument);
  fixes = meeting();
  fixes.heights = {0, 0, 0, 0};
  EXPECT_EQ(add(recording, fixes).error().code, ErrorCode::kInvalidArgument);

  RecordingOutOfCore upright(enough());
  ASSERT_TRUE(add(upright, fixes));
  EXPECT_EQ(add(upright, meeting()).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(code_of(upright, {.threshold_m = 1.0}), ErrorCode::kInvalidArgument);
  fixes.heights[2] = -std::numeric_limits<double>::infinity();
  const auto status = add(upright, fixes);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().location.array, "heights");
}

// What is too small for exact comparison is zero, as in memory.
TEST(RecordingOutOfCore, TinyValues) {
  std::vector<Track> tracks(2);
  tracks[0].fixes = {{1e-40, {1e-35, 0, 0}}, {1.0, {5, 0, 0}}};
  tracks[1].fixes = {{-0.0, {0, 3, -1e-50}}, {1.0, {5, 4, 0}}};
  RecordingOutOfCore recording(enough());
  ASSERT_TRUE(add(recording, test::fixes_of(tracks, 1)));
  std::vector<LargeConflict> found;
  ASSERT_TRUE(find(recording, {.threshold_m = 3.5}, found));
  const auto expected = find_conflicts(tracks, {.threshold_m = 3.5});
  ASSERT_TRUE(expected);
  EXPECT_EQ(found, test::large(expected->conflicts));
}

TEST(RecordingOutOfCore, TwoFixesAtOneTime) {
  RecordingOutOfCore recording(enough());
  ASSERT_TRUE(add(recording, meeting()));
  ASSERT_TRUE(
      add(recording, {{9, 7, 9}, {7.0, 10.0, 0.0}, {{5, 5, 5}, {100, 0, 0}, {1, 1, 1}}, {}}));
  std::vector<LargeConflict> found;
  // Record 5 says again what record 2 has said; record 6 says another place than record 1.
  auto status = find(recording, {.threshold_m = 5.0}, found);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kTimeOrder);
  EXPECT_EQ(status.error().location.record, 5U);
  EXPECT_NE(status.error().message.find("10 s, the first as record 2;"), std::string::npos)
      << status.error().message;
  recording.allow_repeated(true);
  status = find(recording, {.threshold_m = 5.0}, found);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().location.record, 6U);
  EXPECT_TRUE(found.empty());

  RecordingOutOfCore again(enough());
  ASSERT_TRUE(add(again, meeting()));
  ASSERT_TRUE(add(again, meeting()));
  again.allow_repeated(true);
  ASSERT_TRUE(find(again, {.threshold_m = 5.0}, found));
  EXPECT_EQ(found.size(), 1U);
  EXPECT_EQ(again.facts().repeated, 4U);
  EXPECT_EQ(again.facts().copies, 0U);
}

TEST(RecordingOutOfCore, TellsOfAgents) {
  RecordingOutOfCore recording(enough());
  ASSERT_TRUE(recording.add(std::vector<AgentId>{3, 3, 1, 3, 3, 3, 2, 2},
                            std::vector<double>{0, 10, 5, 3, 4, 2, 1, 8},
                            std::vector<Point>(8, {1, 2, 3})));
  std::vector<LargeAgent> agents;
  ASSERT_TRUE(recording.visit_agents([&](const LargeAgent& agent) { agents.push_back(agent); }));
  // Agent 3 at 0, 2, 3, 4, 10: of the intervals 1, 1, 2, 6 the lower one in the middle.
  EXPECT_EQ(agents, (std::vector<LargeAgent>{{1, 1, 5, 5, 0}, {2, 2, 1, 8, 7}, {3, 5, 0, 10, 1}}));
}

TEST(RecordingOutOfCore, AStopEndsIt) {
  std::stop_source stop;
  auto options = enough();
  options.stop = stop.get_token();
  RecordingOutOfCore recording(options);
  const std::vector<Track> tracks = test::turning_tracks(1);
  ASSERT_TRUE(add(recording, test::fixes_of(tracks, 1)));
  stop.request_stop();
  EXPECT_EQ(code_of(recording, {.threshold_m = 5.0}), ErrorCode::kStopped);
  recording.set_run({1, {}});
  std::vector<LargeConflict> found;
  EXPECT_TRUE(find(recording, {.threshold_m = 5.0}, found));

  for (const auto phase :
       {OutOfCoreProgress::Phase::kDistributing, OutOfCoreProgress::Phase::kSearching}) {
    std::stop_source later;
    options.stop = later.get_token();
    options.progress = [&](const OutOfCoreProgress& progress) {
      if (progress.phase == phase) later.request_stop();
    };
    RecordingOutOfCore other(options);
    test::Fixes fixes;
    for (std::uint64_t row = 0; row < 100'000; ++row) {
      fixes.agents.push_back(row % 50);
      fixes.times_s.push_back(static_cast<double>(row / 50));
      fixes.positions.push_back({static_cast<double>(row % 50), 0, 0});
    }
    ASSERT_TRUE(add(other, fixes));
    EXPECT_EQ(code_of(other, {.threshold_m = 0.5}), ErrorCode::kStopped);
  }
}

TEST(RecordingOutOfCore, TellsDamage) {
  for (const std::uint64_t offset : {0U, 57U, 3000U}) {
    RecordingOutOfCore recording(enough());
    ASSERT_TRUE(add(recording, test::fixes_of(test::turning_tracks(1), 1)));
    ASSERT_TRUE(recording.visit_agents([](const LargeAgent&) {}));
    test::damage_last_temporary_file(offset);
    EXPECT_EQ(code_of(recording, {.threshold_m = 5.0}), ErrorCode::kCorrupt);
    EXPECT_FALSE(recording.visit_agents([](const LargeAgent&) {}));
  }
}

// That many agents at one time are searched together, or not at all.
TEST(RecordingOutOfCore, MoreAgentsThanFit) {
  auto options = enough();
  options.memory_bytes = OutOfCoreOptions::kLeastMemoryBytes;
  RecordingOutOfCore recording(options);
  constexpr std::uint64_t kAgents = 40'000;
  test::Fixes fixes;
  for (std::uint64_t row = 0; row < 2 * kAgents; ++row) {
    fixes.agents.push_back(row / 2);
    fixes.times_s.push_back(static_cast<double>(row % 2) * 10.0 + 1e-5 * static_cast<double>(row));
    fixes.positions.push_back({static_cast<double>(row / 2), static_cast<double>(row % 2), 0});
  }
  ASSERT_TRUE(add(recording, fixes));
  std::vector<LargeConflict> found;
  const auto status = find(recording, {.threshold_m = 0.5}, found);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kInvalidArgument);
  EXPECT_NE(status.error().message.find("agents are there"), std::string::npos);
  // With as much as is said it is found.
  const std::size_t at = status.error().message.find(" take ");
  options.memory_bytes =
      std::stoull(status.error().message.substr(at + 6)) * (std::uint64_t{1} << 20U);
  RecordingOutOfCore larger(options);
  ASSERT_TRUE(add(larger, fixes));
  EXPECT_TRUE(find(larger, {.threshold_m = 0.5}, found)) << status.error().message;
}

// Agents with many fixes, and agents of which each has some only.
TEST(RecordingOutOfCoreMemory, IsKeptToWithinATenth) {
  if (test::kSanitized) GTEST_SKIP() << "sanitizers have memory of their own";
  if (!test::reset_peak()) GTEST_SKIP() << "this system does not tell the most memory";
  for (const std::uint64_t fixes_each : {4000U, 20U, 3U}) {
    auto options = enough();
    options.threads = 2;
    const std::uint64_t before = *test::status_bytes("VmRSS:");
    ASSERT_TRUE(test::reset_peak());
    RecordingOutOfCore recording(options);
    scenes::RandomStream random(3);
    constexpr std::uint64_t kAtOnce = 1000;
    std::vector<AgentId> agents(kAtOnce);
    std::vector<double> times_s(kAtOnce);
    std::vector<Point> points(kAtOnce);
    for (std::uint64_t row = 0; row < 2'000'000; row += kAtOnce) {
      for (std::uint64_t at = 0; at < kAtOnce; ++at) {
        agents[at] = at + (row / kAtOnce / fixes_each) * kAtOnce;
        times_s[at] = static_cast<double>(row / kAtOnce) + 1e-6 * static_cast<double>(at);
        points[at] = {10.0 * static_cast<double>(at % 40) + random.uniform(0.0, 3.0),
                      10.0 * static_cast<double>(at / 40) + random.uniform(0.0, 3.0), 0.0};
      }
      ASSERT_TRUE(recording.add(agents, times_s, points));
    }
    std::uint64_t found = 0;
    ASSERT_TRUE(
        recording.find_conflicts({.threshold_m = 7.1}, [&](auto some) { found += some.size(); }));
    EXPECT_GT(found, 500U);  // it has something to find
    EXPECT_GT(recording.facts().windows, 1U);
    const std::uint64_t peak = *test::status_bytes("VmHWM:") - before;
    EXPECT_LT(static_cast<double>(peak), 1.1 * static_cast<double>(kEnough)) << fixes_each;
    std::printf("%llu fixes each: %.1f MiB of 64, %llu windows\n",
                static_cast<unsigned long long>(fixes_each), static_cast<double>(peak) / 1048576.0,
                static_cast<unsigned long long>(recording.facts().windows));
  }
}

}  // namespace
}  // namespace beespace
