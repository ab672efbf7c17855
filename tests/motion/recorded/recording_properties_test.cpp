// Properties of the conflicts of a recording that hold for any input.
#include "tests/support/conflict_printer.hpp"
#include "tests/support/recording_scenes.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace beespace {
namespace {

using test::Tracks;
using Conflicts = std::vector<Conflict>;

std::optional<double> distance_at(const Track& a, const Track& b, double time_s, double max_gap_s) {
  const auto p = position_at(a, time_s, max_gap_s);
  const auto q = position_at(b, time_s, max_gap_s);
  if (!p || !q) return std::nullopt;
  return std::hypot(p->x - q->x, p->y - q->y, p->z - q->z);
}

Tracks turning(std::size_t count, std::uint64_t seed) {
  return scenes::random_turns(count, {100, 100, 30}, {3, 12}, {15.0, 1.0, false}, seed);
}

ConflictOptions closer_than(double threshold_m) {
  ConflictOptions options;
  options.threshold_m = threshold_m;
  return options;
}

// A pair that is too close at a sampled instant is in a reported conflict, and in no other.
TEST(RecordingProperties, APairThatIsTooCloseIsInAReportedConflict) {
  test::SceneMaker make(161803);
  std::size_t seen = 0;
  for (int round = 0; round < test::rounds(40); ++round) {
    SCOPED_TRACE(round);
    Tracks tracks = turning(24, static_cast<std::uint64_t>(round));
    if (round % 2 == 0) tracks = test::coming_and_going(tracks, make);
    ConflictOptions options = closer_than(16);
    if (round % 3 == 0) options.max_gap_s = 1.2;
    const Conflicts conflicts = find_conflicts(tracks, options).value().conflicts;
    for (int sample = 0; sample < 60; ++sample) {
      const double time = make.between(0, 15);
      for (PointId i = 0; i < tracks.size(); ++i) {
        for (PointId j = i + 1; j < tracks.size(); ++j) {
          const auto distance = distance_at(tracks[i], tracks[j], time, options.max_gap_s);
          if (!distance || *distance >= 16 - 1e-9) continue;
          ++seen;
          const auto around =
              std::count_if(conflicts.begin(), conflicts.end(), [&](const Conflict& conflict) {
                return conflict.first == i && conflict.second == j &&
                       conflict.begins_s <= time + 1e-9 && time <= conflict.ends_s + 1e-9 &&
                       conflict.closest_m <= *distance + 1e-9;
              });
          ASSERT_EQ(around, 1) << i << " and " << j << " at " << time << " s: " << *distance;
        }
      }
    }
  }
  EXPECT_GT(seen, static_cast<std::size_t>(test::rounds(2000)));
}

// Throughout a reported conflict the two are too close, and no longer.
TEST(RecordingProperties, ThroughoutAReportedConflictTheTwoAreTooClose) {
  test::SceneMaker make(141421);
  std::size_t sampled = 0;
  for (const test::RecordingScene& scene : test::recording_scenes()) {
    const double unit = scene.threshold_m;
    const bool blurred = scene.name == "EpochTimes" || scene.name == "LatticeFarAway" ||
                         scene.name == "HugeOffsets" || scene.name == "Glitch";
    const double slack = blurred ? 1e-4 : 1e-9 * unit;
    const ConflictOptions options = scene.options(test::Shape::kSphere, false);
    const Conflicts conflicts = find_conflicts(scene.tracks, options).value().conflicts;
    for (const Conflict& conflict : conflicts) {
      if (!conflict.certain || scene.name.find("Tolerances") != std::string::npos) continue;
      ASSERT_LE(conflict.begins_s, conflict.closest_s);
      ASSERT_LE(conflict.closest_s, conflict.ends_s);
      for (const double share : {0.0, 1.0, 0.5, make.between(0, 1), make.between(0, 1)}) {
        const double time = conflict.begins_s + (conflict.ends_s - conflict.begins_s) * share;
        const auto distance = distance_at(scene.tracks[conflict.first],
                                          scene.tracks[conflict.second], time, scene.max_gap_s);
        ASSERT_TRUE(distance.has_value()) << scene.name;
        ASSERT_LT(*distance, unit + slack) << scene.name << ", at " << time;
        ASSERT_GT(*distance, conflict.closest_m - slack) << scene.name << ", at " << time;
        ++sampled;
      }
      const auto closest = distance_at(scene.tracks[conflict.first], scene.tracks[conflict.second],
                                       conflict.closest_s, scene.max_gap_s);
      ASSERT_NEAR(*closest, conflict.closest_m, std::max(slack, 1e-7 * unit)) << scene.name;
    }
  }
  EXPECT_GT(sampled, 10'000U);
}

Conflicts ordered(Conflicts conflicts) {
  std::sort(conflicts.begin(), conflicts.end(), [](const Conflict& a, const Conflict& b) {
    return std::tie(a.first, a.second, a.begins_s) < std::tie(b.first, b.second, b.begins_s);
  });
  return conflicts;
}

TEST(RecordingProperties, TheOrderOfTracksChangesNothingButTheirNumbers) {
  test::SceneMaker make(57721);
  for (const test::RecordingScene& scene : test::recording_scenes()) {
    SCOPED_TRACE(scene.name);
    std::vector<PointId> number(scene.tracks.size());  // the track that was at this place before
    std::iota(number.begin(), number.end(), 0U);
    for (std::size_t left = number.size(); left > 1; --left) {
      std::swap(number[left - 1], number[make.below(left)]);
    }
    Tracks tracks;
    for (const PointId id : number) tracks.push_back(scene.tracks[id]);
    const ConflictOptions options = scene.options(test::Shape::kSphere, true);
    Conflicts found = find_conflicts(tracks, options).value().conflicts;
    for (Conflict& conflict : found) {
      const PointId a = number[conflict.first];
      const PointId b = number[conflict.second];
      conflict.first = std::min(a, b);
      conflict.second = std::max(a, b);
    }
    EXPECT_EQ(ordered(found), find_conflicts(scene.tracks, options).value().conflicts);
  }
}

void expect_near(const Conflicts& found, const Conflicts& expected, double later_s) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].first, expected[k].first);
    EXPECT_EQ(found[k].second, expected[k].second);
    EXPECT_NEAR(found[k].begins_s, expected[k].begins_s + later_s, 1e-7);
    EXPECT_NEAR(found[k].ends_s, expected[k].ends_s + later_s, 1e-7);
    EXPECT_NEAR(found[k].closest_m, expected[k].closest_m, 1e-9);
    EXPECT_EQ(found[k].certain, expected[k].certain);
  }
}

// Whole numbers of places, and times in quarters: halves and shifted times are exact.
Tracks whole_numbers(test::SceneMaker& make) {
  Tracks tracks = test::lattice_tracks(make, 30, 1.0, 0.25);
  for (Track& track : tracks) {
    for (Fix& fix : track.fixes) fix.position.x *= 4.0;
  }
  return tracks;
}

TEST(RecordingProperties, AFixInTheMiddleOfAPieceChangesNothing) {
  test::SceneMaker make(69314);
  std::size_t conflicts = 0;
  for (int round = 0; round < test::rounds(60); ++round) {
    SCOPED_TRACE(round);
    const Tracks tracks = whole_numbers(make);
    Tracks split = tracks;
    for (Track& track : split) {
      std::vector<Fix> fixes;
      for (const Fix& fix : track.fixes) {
        if (!fixes.empty() && make.below(2) == 0) {
          const auto& [time, p] = fixes.back();
          const Point& q = fix.position;
          fixes.push_back({0.5 * (time + fix.time_s),
                           {0.5 * (p.x + q.x), 0.5 * (p.y + q.y), 0.5 * (p.z + q.z)}});
        }
        fixes.push_back(fix);
      }
      track.fixes = fixes;
    }
    for (const bool inclusive : {false, true}) {
      ConflictOptions options = closer_than(5);
      options.inclusive = inclusive;
      const Conflicts found = find_conflicts(split, options).value().conflicts;
      expect_near(found, find_conflicts(tracks, options).value().conflicts, 0.0);
      conflicts += found.size();
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(conflicts, static_cast<std::size_t>(test::rounds(2000)));
}

TEST(RecordingProperties, ConflictsAreAsMuchLaterAsTheRecording) {
  test::SceneMaker make(69314);
  for (int round = 0; round < test::rounds(60); ++round) {
    SCOPED_TRACE(round);
    const Tracks tracks = whole_numbers(make);
    const Conflicts expected = find_conflicts(tracks, closer_than(5)).value().conflicts;
    for (const double later_s : {0x1p+20, -0x1p+21}) {
      const Tracks later = test::moved(tracks, {0, 0, 0}, later_s);
      expect_near(find_conflicts(later, closer_than(5)).value().conflicts, expected, later_s);
    }
    if (HasFailure()) return;
  }
}

TEST(RecordingProperties, TheNumberOfThreadsChangesNothing) {
  for (const test::RecordingScene& scene : test::recording_scenes()) {
    SCOPED_TRACE(scene.name);
    ConflictOptions options = scene.options(test::Shape::kCylinder, false);
    const Conflicts expected = find_conflicts(scene.tracks, options).value().conflicts;
    for (const unsigned threads : {0U, 2U, 3U}) {
      options.threads = threads;
      EXPECT_EQ(find_conflicts(scene.tracks, options).value().conflicts, expected);
    }
  }
}

}  // namespace
}  // namespace beespace
