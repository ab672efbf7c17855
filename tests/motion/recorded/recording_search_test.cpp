// The search through recordings: for every instruction set, number of threads and length of step,
// bit for bit the brute force's answer.
#include "motion/recorded/recording_search.hpp"

#include "tests/support/conflict_printer.hpp"
#include "tests/support/own_resources.hpp"
#include "tests/support/recording_scenes.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace beespace::motion {
namespace {

using test::Shape;
using Conflicts = std::vector<Conflict>;

struct Way {
  cpu::InstructionSet set;
  unsigned threads;
  std::optional<double> step_s;
};

std::string name_of(const Way& way) {
  std::ostringstream name;
  name << cpu::name_of(way.set) << ", " << way.threads << " threads, step ";
  if (way.step_s) {
    name << *way.step_s << " s";
  } else {
    name << "chosen";
  }
  return name.str();
}

// Chosen, one for all, ones that end at fixes where those are regular, and ones that fit nothing.
std::vector<std::optional<double>> steps_of(const test::RecordingScene& scene) {
  const double lasts = scene.lasts_s();
  if (lasts == 0.0) return {std::nullopt, 1.0};
  if (test::kSanitized) return {std::nullopt, std::max(1.0, lasts / 8.0)};
  return {std::nullopt, 1e9 * lasts, std::max(1.0, lasts / 20.0), lasts / 17.3};
}

std::vector<cpu::InstructionSet> available_sets() {
  std::vector<cpu::InstructionSet> sets;
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (cpu::is_available(set)) sets.push_back(set);
  }
  return sets;
}

bool has_tolerances(const test::Tracks& tracks) {
  return std::any_of(tracks.begin(), tracks.end(),
                     [](const Track& track) { return track.tolerance_m > 0.0; });
}

class EveryWay {
 public:
  // Calls check(answer) for every way to search.
  template <class Check>
  void for_each(const test::RecordingScene& scene, const test::Tracks& tracks, Shape shape,
                const ConflictOptions& options, Check&& check) {
    const TrackSegments cut = cut_at_gaps(tracks, options.max_gap_s);
    for (const std::optional<double>& step : steps_of(scene)) {
      for (const cpu::InstructionSet set : available_sets()) {
        for (const unsigned threads : {1U, 2U, 5U}) {
          // All kernels, all numbers of threads, all steps, and not every two of them.
          const bool best = set == cpu::best_instruction_set();
          if (threads > 1 && (!best || step == 1e9 * scene.lasts_s())) continue;
          if (step && (!best || threads == 5)) continue;
          const Way way{set, threads, step};
          SCOPED_TRACE(name_of(way) + ", " + test::name_of(shape) +
                       (options.inclusive ? ", inclusive" : ", strict"));
          check(answer(way, cut.segments, separation_of(options, shape == Shape::kHeightsApart),
                       options.max_results));
          if (testing::Test::HasFatalFailure()) return;
        }
      }
    }
  }

 private:
  Result<Conflicts> answer(const Way& way, const std::vector<TrackSegment>& segments,
                           const Separation& separation, std::uint64_t max_results) {
    RecordingTuning tuning;
    tuning.search.instruction_set = way.set;
    tuning.step_s = way.step_s;
    test::OwnResources& own = way.threads == 1 ? one_ : way.threads == 2 ? two_ : five_;
    own.memory.start_call();
    return search_recording(segments, separation, max_results, own.with, tuning);
  }

  test::OwnResources one_{1};
  test::OwnResources two_{2};
  test::OwnResources five_{5};
};

void expect_same(const Conflicts& found, const Conflicts& expected) {
  for (std::size_t k = 0; k < std::min(found.size(), expected.size()); ++k) {
    ASSERT_EQ(found[k].first, expected[k].first) << "conflict " << k;
    ASSERT_EQ(found[k].second, expected[k].second) << "conflict " << k;
    ASSERT_EQ(found[k], expected[k]) << "the times or distances of conflict " << k;
  }
  ASSERT_EQ(found.size(), expected.size());
}

class RecordingScenes : public testing::TestWithParam<test::RecordingScene> {};

TEST_P(RecordingScenes, AreSearchedAsByBruteForceInEveryWay) {
  EveryWay ways;
  test::for_each_question([&](Shape shape, bool inclusive) {
    const ConflictOptions options = GetParam().options(shape, inclusive);
    const test::Tracks tracks = GetParam().of(shape);
    const RecordedConflicts expected = *brute_force::find_conflicts(tracks, options);
    ways.for_each(GetParam(), tracks, shape, options, [&](const Result<Conflicts>& found) {
      ASSERT_TRUE(found.has_value());
      expect_same(*found, expected.conflicts);
    });
    const RecordedConflicts found = *find_conflicts(tracks, options);
    expect_same(found.conflicts, expected.conflicts);
    EXPECT_EQ(found.gaps, expected.gaps);
  });
}

// One conflict more than allowed is an error for every variant; as many as allowed are none.
TEST_P(RecordingScenes, HaveTheirResultsCountedInEveryWay) {
  ConflictOptions options = GetParam().options(Shape::kSphere, true);
  const test::Tracks& tracks = GetParam().tracks;
  const std::size_t all = brute_force::find_conflicts(tracks, options).value().conflicts.size();
  EveryWay ways;
  options.max_results = all;
  ways.for_each(GetParam(), tracks, Shape::kSphere, options, [&](const Result<Conflicts>& found) {
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(found->size(), all);
  });
  EXPECT_TRUE(brute_force::find_conflicts(tracks, options).has_value());
  EXPECT_TRUE(find_conflicts(tracks, options).has_value());
  if (all == 0) return;
  --options.max_results;
  ways.for_each(GetParam(), tracks, Shape::kSphere, options, [](const Result<Conflicts>& found) {
    ASSERT_FALSE(found.has_value());
    ASSERT_EQ(found.error().code, ErrorCode::kTooManyResults);
  });
  for (const auto& found :
       {brute_force::find_conflicts(tracks, options), find_conflicts(tracks, options)}) {
    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().code, ErrorCode::kTooManyResults);
  }
}

INSTANTIATE_TEST_SUITE_P(Searched, RecordingScenes, testing::ValuesIn(test::recording_scenes()),
                         [](const auto& instance) { return instance.param.name; });

// The comparisons above mean little if hardly any bees meet, or if all of them do.
TEST(RecordingScenesThemselves, HaveConflictsOfAllKinds) {
  std::size_t at_the_edge = 0;
  std::size_t again = 0;  // of a pair that has been in conflict before
  std::size_t possible = 0;
  std::size_t gaps = 0;
  for (const test::RecordingScene& scene : test::recording_scenes()) {
    if (scene.tracks.size() < 6) continue;
    SCOPED_TRACE(scene.name);
    test::for_each_question([&](Shape shape, bool inclusive) {
      const auto found =
          *brute_force::find_conflicts(scene.of(shape), scene.options(shape, inclusive));
      const Conflicts& conflicts = found.conflicts;
      gaps += found.gaps.size();
      at_the_edge += inclusive ? conflicts.size() : 0;
      at_the_edge -= inclusive ? 0 : conflicts.size();
      for (std::size_t k = 0; k < conflicts.size(); ++k) {
        if (!conflicts[k].certain) ++possible;
        if (k > 0 && conflicts[k].first == conflicts[k - 1].first &&
            conflicts[k].second == conflicts[k - 1].second) {
          ++again;
        }
      }
      EXPECT_TRUE(conflicts.size() > 4 || !inclusive) << test::name_of(shape);
    });
  }
  EXPECT_GT(at_the_edge, 250U);
  EXPECT_GT(again, 400U);
  EXPECT_GT(possible, 100U);
  EXPECT_GT(gaps, 400U);
}

// Random places and times, over and over: the same answers, at the chosen step and at short ones.
TEST(RecordingSearch, AgreesWithBruteForceOnManySmallRecordings) {
  test::SceneMaker make(5150);
  test::OwnResources own;
  for (int round = 0; round < test::rounds(1500); ++round) {
    const double unit = round % 2 == 0 ? 1.0 : make.between(0.5, 1.5);
    test::RecordingScene scene{"", test::lattice_tracks(make, 9, unit, unit), 3.0 * unit, 2.0};
    if (round % 3 == 0) scene.tracks = test::with_tolerances(scene.tracks);
    if (round % 4 == 0) scene.max_gap_s = 2.0 * unit;
    const auto shape = static_cast<Shape>(make.below(3));
    const ConflictOptions options = scene.options(shape, make.below(2) == 0);
    const test::Tracks tracks = scene.of(shape);
    const Conflicts expected = brute_force::find_conflicts(tracks, options).value().conflicts;
    const TrackSegments cut = cut_at_gaps(tracks, options.max_gap_s);
    for (const double step : {0.25, 1.0, make.between(0.05, 9.0)}) {
      SCOPED_TRACE(std::to_string(round) + ", step " + std::to_string(step) +
                   (has_tolerances(tracks) ? ", tolerances, " : ", ") + test::name_of(shape));
      RecordingTuning tuning;
      tuning.step_s = step;
      own.memory.start_call();
      const bool apart = shape == Shape::kHeightsApart;
      expect_same(*search_recording(cut.segments, separation_of(options, apart),
                                    options.max_results, own.with, tuning),
                  expected);
      if (HasFatalFailure()) return;
    }
  }
}

// The same as brute force on cylinders, whose corners are farther away than threshold and
// tolerance.
TEST(RecordingSearch, FindsPairsThatTolerancesBringTogetherAtTheCornerOfACylinder) {
  test::Tracks tracks;
  for (const double at : {0.0, 13.8}) {
    tracks.push_back({{{0.0, {at, 0.0, at}}, {1.0, {at, 0.0, at}}}, {}, 2.0});
  }
  ConflictOptions options;
  options.threshold_m = 10.0;
  options.vertical_m = 10.0;
  ASSERT_EQ(brute_force::find_conflicts(tracks, options).value().conflicts.size(), 1U);
  EXPECT_EQ(find_conflicts(tracks, options).value().conflicts.size(), 1U);
}

}  // namespace
}  // namespace beespace::motion
