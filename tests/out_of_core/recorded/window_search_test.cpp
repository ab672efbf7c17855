// Recordings that are cut in time have the answer of brute force, bit for bit: wherever they are
// cut.
#include "out_of_core/recorded/window_search.hpp"

#include "tests/out_of_core/recorded/fixes_of_tracks.hpp"
#include "tests/support/mover_scenes.hpp"
#include "tests/support/recording_scenes.hpp"

#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace beespace {

inline void PrintTo(const LargeConflict& c, std::ostream* out) {  // NOLINT: GoogleTest's name
  *out << std::setprecision(17) << c.first << " and " << c.second << " from " << c.begins_s
       << " to " << c.ends_s << " s, closest " << c.closest_m << " m at " << c.closest_s << " s";
}

namespace out_of_core {
namespace {

using test::Shape;

struct Answer {
  std::vector<LargeConflict> conflicts;
  std::vector<LargeGap> gaps;
  RecordingOutOfCoreFacts facts;
};

// Of fixes that come in pieces of that many, in so little memory that they are sorted in many runs,
// and windows of which each has as little as can be or costs at most that.
struct Way {
  std::uint64_t window_cost;
  unsigned threads;
  std::size_t at_a_time;
};

constexpr std::uint64_t kAnyCost = std::numeric_limits<std::uint64_t>::max();

RecordingPlan plan_for(const Way& way) {
  RecordingPlan plan = *recording_plan_for(std::uint64_t{64} << 20U, 1);
  plan.fixes = {2'000, 40'000};
  plan.waiting = 3'000;
  plan.cost = {1, 1};
  plan.window = kAnyCost;
  plan.cut_for = way.window_cost;
  plan.conflicts = {1'000, 40'000};
  return plan;
}

Result<Answer> answer(const std::vector<Track>& tracks, const ConflictOptions& options,
                      const Way& way) {
  const std::string folder = std::filesystem::temp_directory_path().string();
  const RecordingPlan plan = plan_for(way);
  ThreadCrew crew(way.threads);
  StoredFixes stored(folder, plan.fixes);
  const test::Fixes fixes = test::fixes_of(tracks, 5);
  for (std::size_t begin = 0; begin < fixes.agents.size(); begin += way.at_a_time) {
    const std::size_t count = std::min(way.at_a_time, fixes.agents.size() - begin);
    PointsView part(std::span(fixes.positions).subspan(begin, count));
    if (!fixes.heights.empty()) {
      part = part.with_heights(std::span(fixes.heights).subspan(begin, count));
    }
    const auto added = stored.add(std::span(fixes.agents).subspan(begin, count),
                                  std::span(fixes.times_s).subspan(begin, count), part, crew);
    if (!added) return added.error();
  }
  if (const auto settled = stored.settle(crew); !settled) return settled.error();
  Answer found;
  if (stored.size() == 0) return found;
  const std::stop_token never;
  const std::function<void(const OutOfCoreProgress&)> silent;
  const auto status = search_windows(
      stored, options, false, {plan, folder, crew, never, silent},
      [&](std::span<const LargeConflict> some) {
        found.conflicts.insert(found.conflicts.end(), some.begin(), some.end());
      },
      [&](std::span<const LargeGap> some) {
        found.gaps.insert(found.gaps.end(), some.begin(), some.end());
      },
      found.facts);
  if (!status) return status.error();
  return found;
}

test::Tracks without_tolerances(test::Tracks tracks) {
  for (Track& track : tracks) track.tolerance_m = 0.0;
  return tracks;
}

class CutRecordings : public testing::TestWithParam<test::RecordingScene> {};

TEST_P(CutRecordings, HaveTheAnswerOfBruteForceWhereverTheyAreCut) {
  const Way ways[] = {{1, 1, 17}, {60, 1, 100}, {300, 2, 1'000'000}, {kAnyCost, 1, 7}};
  test::for_each_question([&](Shape shape, bool inclusive) {
    const ConflictOptions options = GetParam().options(shape, inclusive);
    const test::Tracks tracks = without_tolerances(GetParam().of(shape));
    const RecordedConflicts expected = *brute_force::find_conflicts(tracks, options);
    for (const Way& way : ways) {
      SCOPED_TRACE(std::string(test::name_of(shape)) + (inclusive ? ", inclusive" : ", strict") +
                   ", windows of " + std::to_string(way.window_cost));
      const auto found = answer(tracks, options, way);
      ASSERT_TRUE(found.has_value()) << to_string(found.error());
      EXPECT_EQ(found->conflicts, test::large(expected.conflicts));
      EXPECT_EQ(found->gaps, test::large(expected.gaps));
    }
  });
}

// As many as are allowed are none too many, though a window tells of one again.
TEST_P(CutRecordings, HaveTheirResultsCounted) {
  ConflictOptions options = GetParam().options(Shape::kSphere, true);
  const test::Tracks tracks = without_tolerances(GetParam().tracks);
  const std::size_t all = brute_force::find_conflicts(tracks, options).value().conflicts.size();
  options.max_results = all;
  const auto found = answer(tracks, options, {1, 1, 100});
  ASSERT_TRUE(found.has_value()) << to_string(found.error());
  EXPECT_EQ(found->conflicts.size(), all);
  if (all == 0) return;
  --options.max_results;
  const auto refused = answer(tracks, options, {1, 1, 100});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::kTooManyResults);
}

INSTANTIATE_TEST_SUITE_P(All, CutRecordings, testing::ValuesIn(test::recording_scenes()),
                         [](const auto& scene) { return scene.param.name; });

// A window for each instant at which there is a fix.
TEST(CutRecordings, AreCutAtEachInstant) {
  std::vector<Track> tracks(3);
  for (int step = 0; step < 50; ++step) {
    tracks[0].fixes.push_back({0.5 * step, {1.0 * step, 0, 0}});
    tracks[1].fixes.push_back({0.75 * step, {0, 1.0 * step, 0}});
  }
  tracks[2].fixes.push_back({3.1, {0, 0, 0}});
  const auto found = answer(tracks, {.threshold_m = 3.0}, {1, 1, 100});
  ASSERT_TRUE(found.has_value());
  // 0, 0.5, 0.75, 1, 1.5, ... until 24.5; then every 0.75 until 36.75; and 3.1.
  std::size_t instants = 1;
  for (int quarter = 0; quarter <= 147; ++quarter) {
    const bool first = quarter % 2 == 0 && quarter <= 98;
    if (first || quarter % 3 == 0) ++instants;
  }
  EXPECT_EQ(found->facts.windows, instants);
  EXPECT_TRUE(found->facts.encounters);
  EXPECT_EQ(
      found->conflicts,
      test::large(brute_force::find_conflicts(tracks, {.threshold_m = 3.0}).value().conflicts));
}

// Two that fly side by side all the time, and one that was there long before them.
TEST(CutRecordings, OneConflictOverAllBorders) {
  std::vector<Track> tracks(3);
  for (int step = 0; step < 200; ++step) {
    tracks[0].fixes.push_back({1.0 * step, {5.0 * step, 0, 0}});
    tracks[1].fixes.push_back({1.0 * step + 0.5, {5.0 * step + 2.5, 1, 0}});
    tracks[2].fixes.push_back({1.0 * step - 900.0, {0, 0, 0}});
  }
  const auto found = answer(tracks, {.threshold_m = 2.0}, {1, 1, 100});
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->conflicts.size(), 1U);
  EXPECT_EQ(found->conflicts[0].begins_s, 0.5);
  EXPECT_EQ(found->conflicts[0].ends_s, 199.0);
  EXPECT_GT(found->facts.windows, 500U);
}

// At exactly the threshold, and an ulp to either side of it, at a border.
TEST(CutRecordings, AtTheThreshold) {
  for (const double apart : {4.0, std::nextafter(4.0, 0.0), std::nextafter(4.0, 5.0)}) {
    std::vector<Track> tracks(2);
    for (int step = 0; step <= 10; ++step) {
      const double away = std::abs(5.0 - step);
      tracks[0].fixes.push_back({1.0 * step, {0, 0, 0}});
      tracks[1].fixes.push_back({1.0 * step, {apart + away, 0, 0}});
    }
    for (const bool inclusive : {false, true}) {
      ConflictOptions options{.threshold_m = 4.0};
      options.inclusive = inclusive;
      const auto found = answer(tracks, options, {1, 1, 5});
      ASSERT_TRUE(found.has_value());
      EXPECT_EQ(found->conflicts.size(), apart < 4.0 || (inclusive && apart == 4.0) ? 1U : 0U);
      EXPECT_EQ(found->conflicts,
                test::large(brute_force::find_conflicts(tracks, options).value().conflicts));
    }
  }
}

TEST(CutRecordings, WhetherAnyTwoAreThereAtOneTime) {
  const auto meet = [](const std::vector<Track>& tracks, double max_gap_s) {
    ConflictOptions options{.threshold_m = 1.0};
    options.max_gap_s = max_gap_s;
    return answer(tracks, options, {1, 1, 100}).value().facts.encounters;
  };
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Track early{{{0.0, {0, 0, 0}}, {5.0, {9, 9, 9}}}};
  const Track late{{{5.0, {0, 0, 0}}, {7.0, {9, 9, 9}}}};
  const Track later{{{5.5, {0, 0, 0}}, {7.0, {9, 9, 9}}}};
  const Track around{{{-1.0, {0, 0, 0}}, {8.0, {9, 9, 9}}}};
  EXPECT_TRUE(meet({early, late}, kNever));
  EXPECT_FALSE(meet({early, later}, kNever));
  EXPECT_TRUE(meet({early, later, around}, kNever));
  EXPECT_FALSE(meet({early, later, around}, 6.0));
  EXPECT_FALSE(meet({around}, kNever));
}

}  // namespace
}  // namespace out_of_core
}  // namespace beespace
