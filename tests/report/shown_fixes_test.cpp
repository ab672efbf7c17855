// Fixes left out of a page: the shown position of a bee is within the stated error.
#include "report/shown_fixes.hpp"

#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/nearest.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace beespace::report {
namespace {

using test::rounds;
using test::SceneMaker;
using Tracks = std::vector<Track>;

constexpr double kNever = std::numeric_limits<double>::infinity();

std::vector<Gap> gaps_of(const Tracks& tracks, double max_gap_s) {
  const auto found = find_conflicts(tracks, {.threshold_m = 1e-9, .max_gap_s = max_gap_s});
  EXPECT_TRUE(found.has_value());
  return found ? found->gaps : std::vector<Gap>{};
}

ShownFixes shown_of(const Tracks& tracks, double max_gap_s, std::size_t most) {
  return shown_fixes(tracks, gaps_of(tracks, max_gap_s), most);
}

// The part of a page about one bee.
struct ShownBee {
  Track track;
  std::vector<bool> absent_after;  // of each fix

  // Where it is drawn; as docs/page-format.md has it.
  [[nodiscard]] std::optional<Point> at(double time_s) const {
    const auto& fixes = track.fixes;
    for (std::size_t i = 0; i < fixes.size(); ++i) {
      if (fixes[i].time_s == time_s) return fixes[i].position;
      if (i + 1 == fixes.size() || !(fixes[i].time_s < time_s)) continue;
      if (time_s < fixes[i + 1].time_s) {
        return absent_after[i] ? std::nullopt : position_at(track, time_s);
      }
    }
    return std::nullopt;
  }
};

std::vector<ShownBee> bees_of(const ShownFixes& shown) {
  std::vector<ShownBee> bees;
  std::size_t next = 0;
  for (const std::uint32_t count : shown.counts) {
    ShownBee bee;
    for (std::uint32_t i = 0; i < count; ++i, ++next) {
      bee.track.fixes.push_back({shown.times_s.at(next), shown.positions.at(next)});
      bee.absent_after.push_back(std::binary_search(
          shown.absent_after.begin(), shown.absent_after.end(), static_cast<std::uint32_t>(next)));
    }
    bees.push_back(bee);
  }
  EXPECT_EQ(next, shown.times_s.size());
  EXPECT_EQ(next, shown.positions.size());
  return bees;
}

Track random_track(SceneMaker& make) {
  Track track;
  double time_s = make.between(-50.0, 50.0);
  const std::size_t count = make.below(60);
  for (std::size_t i = 0; i < count; ++i) {
    track.fixes.push_back({time_s, make.box(1, {-9, -9, -9}, {9, 9, 9}).front()});
    time_s += make.below(8) == 0 ? make.between(5.0, 30.0) : make.between(0.01, 2.0);
  }
  if (make.below(2) == 0) track.tolerance_m = make.between(0.0, 0.5);
  return track;
}

// How far off those are that are not shown.
double largest_bend(const Track& track, const ShownBee& bee) {
  double bend_m = 0.0;
  for (const Fix& fix : track.fixes) {
    const auto at = bee.at(fix.time_s);
    if (at) bend_m = std::max(bend_m, distance(*at, fix.position));
  }
  return bend_m;
}

void expect_shown_well(const Tracks& tracks, double max_gap_s, std::size_t most) {
  const std::vector<Gap> gaps = gaps_of(tracks, max_gap_s);
  const ShownFixes shown = shown_fixes(tracks, gaps, most);
  const auto bees = bees_of(shown);
  ASSERT_EQ(bees.size(), tracks.size());
  ASSERT_EQ(shown.absent_after.size(), gaps.size());
  double bend_m = 0.0;
  double tolerance_m = 0.0;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    tolerance_m = std::max(tolerance_m, tracks[i].tolerance_m);
    const auto& fixes = tracks[i].fixes;
    bend_m = std::max(bend_m, largest_bend(tracks[i], bees[i]));
    for (std::size_t k = 0; k + 1 < fixes.size(); ++k) {
      for (int share = 0; share <= 8; ++share) {
        const double time_s =
            std::min(fixes[k + 1].time_s,
                     fixes[k].time_s + 0.125 * share * (fixes[k + 1].time_s - fixes[k].time_s));
        const auto there = position_at(tracks[i], time_s, max_gap_s);
        const auto seen = bees[i].at(time_s);
        ASSERT_EQ(there.has_value(), seen.has_value()) << "bee " << i << " at " << time_s;
        if (!there) continue;
        ASSERT_LE(distance(*there, *seen) + tracks[i].tolerance_m, shown.error_m + 1e-9);
      }
    }
  }
  EXPECT_NEAR(shown.error_m, bend_m + tolerance_m, 1e-9) << "more than need be";
}

TEST(ShownFixes, LeftOutFixesAreWithinTheStatedError) {
  SceneMaker make(3);
  for (int round = 0; round < rounds(200); ++round) {
    Tracks tracks;
    const std::size_t bees = make.below(5);
    for (std::size_t i = 0; i < bees; ++i) tracks.push_back(random_track(make));
    for (const std::size_t most : {1u, 7u, 40u, 100'000u}) {
      expect_shown_well(tracks, make.below(2) == 0 ? kNever : 5.0, most);
    }
  }
}

TEST(ShownFixes, AllAreShownWhereTheyAreFewEnough) {
  SceneMaker make(4);
  Tracks tracks(3);
  for (Track& track : tracks) track = random_track(make);
  std::size_t count = 0;
  for (const Track& track : tracks) count += track.fixes.size();
  const ShownFixes all = shown_of(tracks, kNever, count);
  EXPECT_EQ(all.every, 1u);
  EXPECT_EQ(all.times_s.size(), count);
  const ShownFixes half = shown_of(tracks, kNever, count - 1);
  EXPECT_EQ(half.every, 2u);
  EXPECT_LT(half.times_s.size(), count);
}

// A bee with a fix every second, that goes to and fro.
Track zigzag(std::size_t count) {
  Track track;
  for (std::size_t i = 0; i < count; ++i) {
    track.fixes.push_back({static_cast<double>(i), {i % 2 == 0 ? 0.0 : 3.0, 0, 0}});
  }
  return track;
}

TEST(ShownFixes, OfEachBeeTheFirstAndTheLastStay) {
  const Tracks tracks = {zigzag(10), zigzag(1), zigzag(0), zigzag(12), zigzag(2)};
  const ShownFixes shown = shown_of(tracks, kNever, 5);
  EXPECT_EQ(shown.every, 5u);
  EXPECT_EQ(shown.counts, (std::vector<std::uint32_t>{3, 1, 0, 4, 2}));
  EXPECT_EQ(shown.times_s, (std::vector<double>{0, 5, 9, 0, 0, 5, 10, 11, 0, 1}));
  EXPECT_TRUE(shown.absent_after.empty());
}

TEST(ShownFixes, ThoseBesideGapsStayAndTheGapsAreThere) {
  Track track = zigzag(12);
  for (std::size_t i = 4; i < 12; ++i) track.fixes[i].time_s += 100.0;  // after the fourth
  const Tracks tracks = {zigzag(6), track};
  const ShownFixes shown = shown_of(tracks, 10.0, 1);
  EXPECT_EQ(shown.times_s, (std::vector<double>{0, 5, 0, 3, 104, 111}));
  EXPECT_EQ(shown.absent_after, (std::vector<std::uint32_t>{3}));
}

TEST(ShownFixes, GapsMayFollowOneAnother) {
  Track track;
  for (const double time_s : {0.0, 100.0, 200.0, 201.0, 202.0, 300.0}) {
    track.fixes.push_back({time_s, {time_s, 0, 0}});
  }
  for (const std::size_t most : {100u, 3u, 1u}) {
    const Tracks tracks = {track, zigzag(2), track};
    const ShownFixes shown = shown_of(tracks, 10.0, most);
    const bool all = most == 100;
    EXPECT_EQ(shown.counts,
              (all ? std::vector<std::uint32_t>{6, 2, 6} : std::vector<std::uint32_t>{5, 2, 5}));
    EXPECT_EQ(shown.absent_after, (all ? std::vector<std::uint32_t>{0, 1, 4, 8, 9, 12}
                                       : std::vector<std::uint32_t>{0, 1, 3, 7, 8, 10}));
  }
}

TEST(ShownFixes, ABeeThatIsAbsentBetweenAllItsFixesIsShownAtEachOfThem) {
  const Tracks tracks = {zigzag(50)};
  const ShownFixes shown = shown_of(tracks, 0.5, 1);
  EXPECT_EQ(shown.counts, (std::vector<std::uint32_t>{50}));
  EXPECT_EQ(shown.absent_after.size(), 49u);
  EXPECT_EQ(shown.error_m, 0.0);
}

TEST(ShownFixes, TheErrorIsThatOfTheWorstBeeAndItsTolerance) {
  Tracks tracks = {zigzag(9), zigzag(1)};
  EXPECT_EQ(shown_of(tracks, kNever, 100).error_m, 0.0);
  EXPECT_EQ(shown_of(tracks, kNever, 5).error_m, 3.0);
  tracks[1].tolerance_m = 0.25;
  EXPECT_EQ(shown_of(tracks, kNever, 100).error_m, 0.25);
  EXPECT_EQ(shown_of(tracks, kNever, 5).error_m, 3.25);
}

TEST(ShownFixes, OfNoBeesAreNone) {
  const ShownFixes none = shown_of({}, kNever, 10);
  EXPECT_EQ(none.every, 1u);
  EXPECT_TRUE(none.counts.empty() && none.times_s.empty() && none.absent_after.empty());
  const ShownFixes absent = shown_of({Track{}, Track{}}, kNever, 10);
  EXPECT_EQ(absent.counts, (std::vector<std::uint32_t>{0, 0}));
}

TEST(RunsOf, EndAtGapsAndAtTheLastFixOfABee) {
  ShownFixes shown;
  shown.counts = {0, 4, 1, 0, 3, 2};
  shown.absent_after = {1, 4, 5, 6};  // one of them after the last fix of a bee
  std::vector<std::vector<std::size_t>> runs;
  for (const ShownRun& run : runs_of(shown)) runs.push_back({run.bee, run.begin, run.end});
  EXPECT_EQ(runs,
            (std::vector<std::vector<std::size_t>>{
                {1, 0, 2}, {1, 2, 4}, {2, 4, 5}, {4, 5, 6}, {4, 6, 7}, {4, 7, 8}, {5, 8, 10}}));
  EXPECT_TRUE(runs_of({}).empty());
}

}  // namespace
}  // namespace beespace::report
