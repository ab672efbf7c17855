// What follows from conflicts for pairs, bees and moments.
#include "analysis/recorded/findings.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace beespace::analysis {
namespace {

Conflict conflict_of(PointId first, PointId second, double begins_s, double ends_s,
                     double closest_m) {
  Conflict conflict;
  conflict.first = first;
  conflict.second = second;
  conflict.begins_s = begins_s;
  conflict.ends_s = ends_s;
  conflict.closest_s = begins_s;
  conflict.closest_m = closest_m;
  return conflict;
}

TEST(Findings, PairsComeTheClosestFirst) {
  const auto pairs =
      pairs_in_conflict({conflict_of(0, 1, 0.0, 2.0, 3.0), conflict_of(0, 1, 5.0, 6.0, 2.5),
                         conflict_of(1, 2, 1.0, 4.0, 1.0)});
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].closest.closest_m, 1.0);
  EXPECT_EQ(pairs[1].closest.closest_m, 2.5);
  EXPECT_EQ(pairs[1].conflicts, 2U);
  EXPECT_EQ(pairs[1].time_s, 3.0);
}

TEST(Findings, TimeInSeveralConflictsAtOnceCountsOnce) {
  const std::vector<Conflict> conflicts = {conflict_of(0, 1, 0.0, 4.0, 3.0),
                                           conflict_of(1, 2, 2.0, 6.0, 1.0)};
  const auto bees = bees_in_conflict(4, conflicts);
  ASSERT_EQ(bees.size(), 4U);
  EXPECT_EQ(bees[1].conflicts, 2U);
  EXPECT_EQ(bees[1].time_s, 6.0);
  EXPECT_EQ(bees[1].closest, &conflicts[1]);
  EXPECT_EQ(bees[0].time_s, 4.0);
  EXPECT_EQ(bees[3].conflicts, 0U);
  EXPECT_EQ(bees[3].closest, nullptr);
}

// Two meet in the gap of one of them; a third one stands 50 m away from the first.
TEST(Findings, HowFarApartIsOpenWhereOneMayBeCloserInItsGap) {
  std::vector<Track> tracks(3);
  tracks[0].fixes = {{0.0, {0.0, 0.0, 0.0}}, {5.0, {0.0, 0.0, 0.0}}, {10.0, {0.0, 0.0, 0.0}}};
  tracks[1].fixes = {{0.0, {-10.0, 1.0, 0.0}}, {10.0, {10.0, 1.0, 0.0}}};
  tracks[2].fixes = {{0.0, {0.0, 50.0, 0.0}}, {5.0, {0.0, 50.0, 0.0}}, {10.0, {0.0, 50.0, 0.0}}};
  const io::Recording recording;
  const RecordedConflicts recorded;
  Coverage coverage;
  coverage.max_gap.seconds = 5.0;
  const auto moments =
      separation_over_time({recording, tracks, tracks, recorded, {}, coverage, true}, 5.0);
  ASSERT_EQ(moments.size(), 3U);
  EXPECT_FALSE(moments[0].open || moments[2].open);
  EXPECT_TRUE(moments[1].open);
  EXPECT_EQ(moments[1].unknown, 1U);
  EXPECT_EQ(moments[1].distance_m, 50.0);
  // Far away in its gap, it leaves nothing open.
  for (Fix& fix : tracks[1].fixes) fix.position.y = 500.0;
  const auto far =
      separation_over_time({recording, tracks, tracks, recorded, {}, coverage, true}, 5.0);
  EXPECT_FALSE(far[1].open);
}

TEST(Findings, TimeIsFromTheFirstFixToTheLast) {
  EXPECT_FALSE(time_of({}).has_value());
  std::vector<Track> tracks(3);
  tracks[0].fixes = {{3.0, {}}, {9.0, {}}};
  tracks[2].fixes = {{1.0, {}}};
  const auto time = time_of(tracks);
  ASSERT_TRUE(time.has_value());
  EXPECT_EQ(time->begins_s, 1.0);
  EXPECT_EQ(time->ends_s, 9.0);
}

}  // namespace
}  // namespace beespace::analysis
