// The closest encounter of a recording, compared with fractions and brute force.
#include "tests/support/conflict_printer.hpp"
#include "tests/support/exact_recording_oracle.hpp"
#include "tests/support/recording_scenes.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace beespace {
namespace {

using test::Tracks;

// Coordinates are whole metres below a hundred: all pairs are in conflict all the time.
ConflictOptions all_in_conflict(double max_gap_s) {
  ConflictOptions options;
  options.threshold_m = 1000.0;
  options.inclusive = true;
  options.max_gap_s = max_gap_s;
  return options;
}

TEST(ClosestEncounter, OfWholeNumbersIsTheClosestByFractions) {
  test::SceneMaker make(8086);
  std::size_t none_together = 0;
  for (int round = 0; round < test::rounds(200); ++round) {
    SCOPED_TRACE(round);
    const Tracks tracks = test::lattice_tracks(make, 1 + make.below(7), 1.0, 1.0);
    const double max_gap_s = round % 3 == 0 ? 2.0 : std::numeric_limits<double>::infinity();
    const ConflictOptions all = all_in_conflict(max_gap_s);
    std::optional<test::Wide> least;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      for (std::size_t j = i + 1; j < tracks.size(); ++j) {
        for (const auto& stretch : test::ExactRecording(tracks[i], tracks[j], all).stretches()) {
          if (!least || stretch.closest_m < *least) least = stretch.closest_m;
        }
      }
    }
    const auto found = find_closest_encounter(tracks, max_gap_s);
    ASSERT_TRUE(found.has_value()) << found.error().message;
    ASSERT_EQ(found->has_value(), least.has_value());
    if (!least) {
      ++none_together;
      continue;
    }
    const Conflict& closest = **found;
    EXPECT_NEAR(closest.closest_m, least->convert_to<double>(), 1e-12);
    EXPECT_LT(closest.first, closest.second);
    EXPECT_EQ(closest.begins_s, closest.closest_s);
    EXPECT_EQ(closest.ends_s, closest.closest_s);
    const auto then = test::ExactRecording(tracks[closest.first], tracks[closest.second], all)
                          .squared_distance(test::Fraction(closest.closest_s));
    ASSERT_TRUE(then.has_value());
    EXPECT_NEAR(std::sqrt(then->convert_to<double>()), closest.closest_m, 1e-6);
  }
  EXPECT_GT(none_together, static_cast<std::size_t>(test::rounds(20)));
}

TEST(ClosestEncounter, OfEveryRecordingIsTheLeastOfBruteForce) {
  for (const test::RecordingScene& scene : test::recording_scenes()) {
    SCOPED_TRACE(scene.name);
    ConflictOptions all = all_in_conflict(scene.max_gap_s);
    all.threshold_m = kLargestInMotion;
    const auto conflicts = brute_force::find_conflicts(scene.tracks, all).value().conflicts;
    for (const unsigned threads : {1U, 3U}) {
      const auto found = find_closest_encounter(scene.tracks, scene.max_gap_s, threads);
      ASSERT_TRUE(found.has_value()) << found.error().message;
      ASSERT_EQ(found->has_value(), !conflicts.empty());
      if (conflicts.empty()) continue;
      double least = std::numeric_limits<double>::infinity();
      for (const Conflict& conflict : conflicts) least = std::min(least, conflict.closest_m);
      EXPECT_EQ((*found)->closest_m, least);
    }
  }
}

TEST(ClosestEncounter, OfNoneAndOfOneIsNothing) {
  const Track hovering{{{0.0, {1, 2, 3}}, {9.0, {1, 2, 3}}}};
  for (const Tracks& tracks : {Tracks{}, Tracks{{}, {}}, Tracks{hovering}}) {
    const auto found = find_closest_encounter(tracks);
    ASSERT_TRUE(found.has_value()) << found.error().message;
    EXPECT_FALSE(found->has_value());
  }
}

TEST(ClosestEncounter, OfTwoAtOnePlaceIsThere) {
  const Track hovering{{{0.0, {1, 2, 3}}, {9.0, {1, 2, 3}}}};
  const auto found = find_closest_encounter(Tracks{hovering, hovering});
  ASSERT_TRUE(found.has_value()) << found.error().message;
  ASSERT_TRUE(found->has_value());
  EXPECT_EQ((*found)->closest_m, 0.0);
}

// A pair that tolerances may bring closer is found first, and is not the closest.
TEST(ClosestEncounter, IsTheClosestPathsWhateverTheirTolerances) {
  const auto at = [](double x, double tolerance_m) {
    return Track{{{0.0, {x, 0, 0}}}, {}, tolerance_m};
  };
  const Tracks tracks = {at(0, 3), at(5, 3), at(100, 0), at(102, 0), at(4000, 0)};
  const auto found = find_closest_encounter(tracks);
  ASSERT_TRUE(found.has_value() && found->has_value());
  EXPECT_EQ((*found)->first, 2U);
  EXPECT_EQ((*found)->second, 3U);
  EXPECT_EQ((*found)->closest_m, 2.0);
}

TEST(ClosestEncounter, AtTheEndsOfTheDomainIsFoundAsWell) {
  const auto at = [](double x) { return Track{{{0.0, {x, 0, 0}}}}; };
  const auto tiny = find_closest_encounter(Tracks{at(0), at(kSmallestInMotion)});
  ASSERT_TRUE(tiny.has_value()) << tiny.error().message;
  ASSERT_TRUE(tiny->has_value());
  EXPECT_EQ((*tiny)->closest_m, kSmallestInMotion);
  const auto huge = find_closest_encounter(Tracks{at(0), at(kLargestInMotion)});
  ASSERT_TRUE(huge.has_value()) << huge.error().message;
  ASSERT_TRUE(huge->has_value());
  EXPECT_EQ((*huge)->closest_m, kLargestInMotion);
  // Across the whole domain: farther than any threshold that find_conflicts takes.
  const auto across = find_closest_encounter(Tracks{at(-kLargestInMotion), at(kLargestInMotion)});
  ASSERT_TRUE(across.has_value()) << across.error().message;
  ASSERT_TRUE(across->has_value());
  EXPECT_EQ((*across)->closest_m, 2.0 * kLargestInMotion);
}

TEST(ClosestEncounter, RefusesWhatFindConflictsRefuses) {
  Tracks tracks = {{{{0.0, {1, 2, 3}}, {0.0, {1, 2, 3}}}}};
  const auto order = find_closest_encounter(tracks);
  ASSERT_FALSE(order.has_value());
  EXPECT_EQ(order.error().code, ErrorCode::kTimeOrder);
  const auto gap = find_closest_encounter(Tracks{}, 0.0);
  ASSERT_FALSE(gap.has_value());
  EXPECT_EQ(gap.error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace beespace
