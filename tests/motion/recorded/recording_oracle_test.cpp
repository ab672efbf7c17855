// find_conflicts on two tracks, compared with the definition in fractions; and recordings whose
// conflicts are obvious.
#include "tests/support/conflict_printer.hpp"
#include "tests/support/exact_recording_oracle.hpp"
#include "tests/support/recording_scenes.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace beespace {
namespace {

using test::ExactStretch;
using test::Shape;
using test::Tracks;

// Of two tracks, 0 and 1, in both ways.
std::vector<Conflict> conflicts_of(const Tracks& tracks, const ConflictOptions& options) {
  const auto brute = *brute_force::find_conflicts(tracks, options);
  EXPECT_EQ(find_conflicts(tracks, options).value().conflicts, brute.conflicts);
  return brute.conflicts;
}

double squared_distance(const Track& a, const Track& b, const ConflictOptions& options,
                        double time_s) {
  const auto squared = test::ExactRecording(a, b, options).squared_distance(test::Fraction(time_s));
  EXPECT_TRUE(squared.has_value()) << "one of them is not there at " << time_s;
  return squared.value_or(test::Fraction(-1)).convert_to<double>();
}

void expect_as_exact(const Tracks& tracks, const ConflictOptions& options,
                     const std::vector<Conflict>& found) {
  const std::vector<ExactStretch> exact =
      test::ExactRecording(tracks[0], tracks[1], options).stretches();
  ASSERT_EQ(found.size(), exact.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    SCOPED_TRACE("conflict " + std::to_string(k));
    constexpr double kRounded = 1e-7;  // roots of what nearly cancels
    EXPECT_NEAR(found[k].begins_s, exact[k].begins.convert_to<double>(), kRounded);
    EXPECT_NEAR(found[k].ends_s, exact[k].ends.convert_to<double>(), kRounded);
    EXPECT_NEAR(found[k].closest_m, exact[k].closest_m.convert_to<double>(),
                options.vertical_m ? kRounded : 1e-12);  // of cylinders, perhaps at such a root
    EXPECT_LE(found[k].begins_s, found[k].closest_s);
    EXPECT_LE(found[k].closest_s, found[k].ends_s);
    const double then = squared_distance(tracks[0], tracks[1], options, found[k].closest_s);
    EXPECT_NEAR(std::sqrt(then), found[k].closest_m, 1e-6);
  }
}

TEST(RecordedConflicts, OfSmallWholeNumbersAreWhatFractionsSay) {
  test::SceneMaker make(31415);
  std::size_t conflicts = 0;
  std::size_t touching = 0;
  for (int round = 0; round < test::rounds(4000); ++round) {
    SCOPED_TRACE(round);
    test::RecordingScene scene{"", test::lattice_tracks(make, 2, 1.0, 1.0), 3.0, 2.0};
    if (round % 5 == 0) scene.max_gap_s = 2.0;
    const auto shape = static_cast<Shape>(make.below(3));
    const Tracks tracks = scene.of(shape);
    std::size_t found[2] = {};
    for (const bool inclusive : {false, true}) {
      const ConflictOptions options = scene.options(shape, inclusive);
      const std::vector<Conflict> answer = conflicts_of(tracks, options);
      expect_as_exact(tracks, options, answer);
      for (const Conflict& conflict : answer) EXPECT_TRUE(conflict.certain);
      found[inclusive ? 1 : 0] = answer.size();
      if (HasFailure()) return;
    }
    conflicts += found[1];
    touching += found[0] == found[1] ? 0 : 1;
  }
  EXPECT_GT(conflicts, static_cast<std::size_t>(test::rounds(1500)));
  EXPECT_GT(touching, static_cast<std::size_t>(test::rounds(60)));
}

// By tolerances that nothing of whole numbers is exactly at.
TEST(RecordedConflicts, AreAsLongAsTolerancesLeaveOpenAndCertainWhereTheyDoNot) {
  test::SceneMaker make(27182);
  std::size_t certain = 0;
  std::size_t possible = 0;
  for (int round = 0; round < test::rounds(2500); ++round) {
    SCOPED_TRACE(round);
    test::RecordingScene scene{"", test::lattice_tracks(make, 2, 1.0, 1.0), 2.0, 2.0};
    const auto shape = static_cast<Shape>(make.below(3));
    Tracks tracks = scene.of(shape);
    const ConflictOptions options = scene.options(shape, make.below(2) == 0);
    tracks[0].tolerance_m = 0.3;
    tracks[1].tolerance_m = round % 2 == 0 ? 0.0 : make.between(0.01, 0.9);
    const double tolerance_m = tracks[0].tolerance_m + tracks[1].tolerance_m;
    const auto changed = [&](double by_m) {
      ConflictOptions other = options;
      other.threshold_m += by_m;
      if (other.vertical_m) *other.vertical_m += by_m;
      return other;
    };
    const std::vector<Conflict> found =
        brute_force::find_conflicts(tracks, options).value().conflicts;
    expect_as_exact(tracks, changed(tolerance_m), found);
    const auto inner = changed(-tolerance_m);
    const std::vector<ExactStretch> sure =
        test::ExactRecording(tracks[0], tracks[1], inner).stretches();
    for (const Conflict& conflict : found) {
      const bool any = std::any_of(sure.begin(), sure.end(), [&](const ExactStretch& stretch) {
        return stretch.begins >= conflict.begins_s - 1e-7 && stretch.ends <= conflict.ends_s + 1e-7;
      });
      EXPECT_EQ(conflict.certain, any);
      (any ? certain : possible) += 1;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(certain, static_cast<std::size_t>(test::rounds(300)));
  EXPECT_GT(possible, static_cast<std::size_t>(test::rounds(300)));
}

// Brute force is checked by fractions where one recording has many tracks, too.
TEST(RecordedConflicts, OfALatticeAreThoseOfEachPairByFractions) {
  for (const test::RecordingScene& scene : test::recording_scenes()) {
    if (scene.name != "Lattice" && scene.name != "LatticeWithGaps") continue;
    SCOPED_TRACE(scene.name);
    const std::size_t stride = test::kSanitized ? 17 : 1;
    const ConflictOptions options = scene.options(Shape::kCylinder, true);
    const auto found = brute_force::find_conflicts(scene.tracks, options).value().conflicts;
    auto next = found.begin();
    for (PointId i = 0; i < scene.tracks.size(); ++i) {
      for (PointId j = i + 1; j < scene.tracks.size(); ++j) {
        std::size_t said = 0;
        for (; next != found.end() && next->first == i && next->second == j; ++next) ++said;
        if ((i + j) % stride != 0) continue;
        const test::ExactRecording pair(scene.tracks[i], scene.tracks[j], options);
        ASSERT_EQ(said, pair.stretches().size()) << i << " " << j;
      }
    }
    EXPECT_EQ(next, found.end()) << "out of order";
  }
}

ConflictOptions closer_than(double threshold_m, bool inclusive) {
  ConflictOptions options;
  options.threshold_m = threshold_m;
  options.inclusive = inclusive;
  return options;
}

// Passes at exactly 5 m, at time 4, in the middle of a piece.
TEST(RecordedConflicts, AGrazeAtExactlyTheThresholdIsOneInstantAndOnlyInclusive) {
  const Tracks tracks = {{{{0, {-8, 5, 0}}, {8, {8, 5, 0}}}}, {{{0, {0, 0, 0}}, {9, {0, 0, 0}}}}};
  EXPECT_TRUE(conflicts_of(tracks, closer_than(5, false)).empty());
  const std::vector<Conflict> grazes = conflicts_of(tracks, closer_than(5, true));
  ASSERT_EQ(grazes.size(), 1U);
  EXPECT_NEAR(grazes[0].begins_s, 4.0, 1e-14);
  EXPECT_EQ(grazes[0].closest_s, 4.0);
  EXPECT_NEAR(grazes[0].ends_s, 4.0, 1e-14);
  EXPECT_EQ(grazes[0].closest_m, 5.0);
}

// Comes to exactly 5 m at a fix, and turns back.
TEST(RecordedConflicts, AContactExactlyAtAFixIsOneInstantAndOnlyInclusive) {
  const Tracks tracks = {{{{0, {9, 0, 0}}, {2, {5, 0, 0}}, {4, {9, 0, 0}}}},
                         {{{0, {0, 0, 0}}, {3, {0, 0, 0}}, {8, {0, 0, 0}}}}};
  EXPECT_TRUE(conflicts_of(tracks, closer_than(5, false)).empty());
  const Conflict contact{0, 1, 2, 2, 2, 5, true};
  EXPECT_EQ(conflicts_of(tracks, closer_than(5, true)), std::vector{contact});
}

// Comes close, goes to exactly 5 m at a fix, and comes back: apart at that instant, or not.
TEST(RecordedConflicts, AnInstantAtExactlyTheThresholdPartsTwoOnlyWhenStrict) {
  const Tracks tracks = {{{{0, {9, 0, 0}}, {4, {1, 0, 0}}, {6, {5, 0, 0}}, {8, {2, 0, 0}}}},
                         {{{0, {0, 0, 0}}, {8, {0, 0, 0}}}}};
  const std::vector<Conflict> two = {{0, 1, 2, 4, 6, 1, true}, {0, 1, 6, 8, 8, 2, true}};
  EXPECT_EQ(conflicts_of(tracks, closer_than(5, false)), two);
  EXPECT_EQ(conflicts_of(tracks, closer_than(5, true)),
            (std::vector<Conflict>{{0, 1, 2, 4, 8, 1, true}}));
}

// The same in height: level with each other, at exactly 2 m at a fix.
TEST(RecordedConflicts, AnInstantAtExactlyTheHeightPartsTwoOnlyWhenStrict) {
  const Tracks tracks = {{{{0, {3, 0, 0}}, {4, {3, 0, 2}}, {6, {3, 0, 1}}}},
                         {{{0, {0, 0, 0}}, {6, {0, 0, 0}}}}};
  ConflictOptions options = closer_than(5, false);
  options.vertical_m = 2.0;
  EXPECT_EQ(conflicts_of(tracks, options).size(), 2U);
  options.inclusive = true;
  EXPECT_EQ(conflicts_of(tracks, options).size(), 1U);
}

TEST(RecordedConflicts, AConflictOverManyFixesIsOneStretch) {
  Tracks tracks(2);
  for (int i = 0; i <= 300; ++i) tracks[0].fixes.push_back({0.25 * i, {std::abs(i - 150.0), 0, 0}});
  for (int i = 0; i <= 70; ++i) tracks[1].fixes.push_back({1.0 * i, {0, 0, 0}});
  EXPECT_EQ(conflicts_of(tracks, closer_than(20, false)),
            (std::vector<Conflict>{{0, 1, 32.5, 37.5, 42.5, 0, true}}));
}

TEST(RecordedConflicts, BeesAtOnePlaceAreInConflictAllTheTimeTheyShare) {
  const Tracks tracks = {{{{0, {1, 2, 3}}, {4, {1, 2, 3}}, {9, {1, 2, 3}}}},
                         {{{2, {1, 2, 3}}, {3, {1, 2, 3}}, {12, {1, 2, 3}}}},
                         {{{9, {1, 2, 3}}}}};
  const std::vector<Conflict> all = {
      {0, 1, 2, 2, 9, 0, true}, {0, 2, 9, 9, 9, 0, true}, {1, 2, 9, 9, 9, 0, true}};
  EXPECT_EQ(conflicts_of(tracks, closer_than(1, false)), all);
}

TEST(RecordedConflicts, GapsAreNamedAndHaveNoConflicts) {
  const Tracks tracks = {{{{0, {0, 0, 0}}, {4, {0, 0, 0}}, {9, {0, 0, 0}}, {11, {0, 0, 0}}}},
                         {{{1, {1, 0, 0}}, {3, {1, 0, 0}}, {5, {1, 0, 0}}, {10, {1, 0, 0}}}},
                         {}};
  ConflictOptions options = closer_than(5, false);
  options.max_gap_s = 4.5;
  const std::vector<Conflict> expected = {{0, 1, 1, 1, 4, 1, true}, {0, 1, 10, 10, 10, 1, true}};
  EXPECT_EQ(conflicts_of(tracks, options), expected);
  for (const auto& found :
       {*find_conflicts(tracks, options), *brute_force::find_conflicts(tracks, options)}) {
    EXPECT_EQ(found.gaps, (std::vector<Gap>{{0, 4, 9}, {1, 5, 10}}));
  }
  options.max_gap_s = 5.0;  // no more than that is none
  EXPECT_TRUE(find_conflicts(tracks, options).value().gaps.empty());
  EXPECT_EQ(conflicts_of(tracks, options), (std::vector<Conflict>{{0, 1, 1, 1, 10, 1, true}}));
}

}  // namespace
}  // namespace beespace
