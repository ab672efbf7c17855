#include "analysis/recorded/unknown_while_set.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace beespace::analysis {
namespace {

// Stands until 5 s, is 10 m up from 15 s to 25 s, and stands from 35 s to 40 s.
const Track kSet{{{0, {0, 0, 0}},
                  {5, {0, 0, 0}},
                  {15, {0, 0, 10}},
                  {25, {0, 0, 10}},
                  {35, {0, 0, 0}},
                  {40, {0, 0, 0}}}};

// A fix each second of that, but for one between those times.
io::Recording flown_without(double from_s, double to_s) {
  io::Recording recording;
  recording.frame = io::Frame::kMetres;
  io::RecordedBee bee;
  bee.id = "a";
  for (int second = 0; second <= 50; ++second) {
    const double time_s = second;
    if (time_s > from_s && time_s < to_s) continue;
    bee.fixes.push_back({time_s, {0, 0, time_s > 5.0 && time_s < 35.0 ? 9.0 : 0.0}});
  }
  recording.bees = {bee};
  return recording;
}

std::vector<TimeSpan> unknown_of(const io::Recording& recording) {
  const std::vector<Track> tracks = {{recording.bees[0].fixes}};
  const MaxGap max_gap = max_gap_of(recording, std::nullopt);
  return unknown_while_set(kSet, tracks[0], 0, unknown_spans_of(recording, tracks, max_gap),
                           max_gap);
}

TEST(UnknownWhileSet, IsAGap) {
  EXPECT_TRUE(unknown_of(flown_without(100, 100)).empty());
  EXPECT_TRUE(unknown_of(flown_without(20, 24)).empty());  // no longer than is usual
  EXPECT_EQ(unknown_of(flown_without(18, 26)), (std::vector<TimeSpan>{{18, 26}}));
  EXPECT_EQ(length_of(unknown_of(flown_without(18, 26))), 8.0);
  // Nothing is set from 40 s on.
  EXPECT_EQ(unknown_of(flown_without(38, 48)), (std::vector<TimeSpan>{{38, 40}}));
}

// A log may begin and end while the drone stands where it is set to.
TEST(UnknownWhileSet, IsWhatIsSetToBeFlownBeforeTheFirstFixAndAfterTheLastOne) {
  EXPECT_TRUE(unknown_of(flown_without(-1, 4)).empty());
  EXPECT_TRUE(unknown_of(flown_without(36, 51)).empty());
  EXPECT_EQ(unknown_of(flown_without(-1, 12)), (std::vector<TimeSpan>{{5, 12}}));
  EXPECT_EQ(unknown_of(flown_without(20, 51)), (std::vector<TimeSpan>{{20, 35}}));
}

TEST(UnknownWhileSet, IsAllOfItWithoutAnyFix) {
  EXPECT_EQ(unknown_while_set(kSet, {}, 0, {}, {5.0, 1.0}), (std::vector<TimeSpan>{{0, 40}}));
  EXPECT_TRUE(unknown_while_set({}, {}, 0, {}, {5.0, 1.0}).empty());
}

}  // namespace
}  // namespace beespace::analysis
