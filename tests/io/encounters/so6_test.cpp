// Segments of so6: both ends are fixes, in minutes of arc and flight levels, and what is between
// them is known.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

const std::string kSegment =
    "P0_P1 EDDF LFPG A320 120000 120200 350 355 2 DLH4AB 240701 240701 3000.000000 421.5 "
    "3000.000000 444.0 1000 1 15.010118 0\n";

TEST(So6, TheEndsOfSegmentsAreFixes) {
  const auto recording = recording_of(
      record(kSegment +
             "P1_P2 EDDF LFPG A320 120200 120400 355 350 2 DLH4AB 240701 240701 3000.000000 444.0 "
             "3000.000000 468.0 1000 2 15.010118 0\n"));
  ASSERT_EQ(ids_of(recording), std::vector<std::string>{"1000"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.label, "DLH4AB");
  ASSERT_EQ(bee.fixes.size(), 5u);
  EXPECT_EQ(bee.fixes[0], (Fix{1719835200, {7.025, 50.0, 10668.0}}));
  EXPECT_EQ(bee.fixes[2], (Fix{1719835320, {7.4, 50.0, 10820.4}}));
  EXPECT_EQ(bee.fixes[4], (Fix{1719835440, {7.8, 50.0, 10668.0}}));
  EXPECT_EQ(bee.stated_heights, (std::vector<double>{35000, 35250, 35500, 35250, 35000}));
  EXPECT_EQ(recording.heights, HeightDatum::kPressure);
  EXPECT_EQ(recording.format_description, "segments of so6");
}

// A minute of arc north and 12 a minute east, for an hour: a great circle bends to the north.
TEST(So6, ALongSegmentIsOneStraightLineAndItsSharedEndsAreNoRepetition) {
  const auto recording = recording_of(
      record(kSegment +
             "P1_P2 EDDF LFPG A320 120200 130200 355 355 2 DLH4AB 240701 240701 3000.000000 444.0 "
             "3000.000000 1164.0 1000 2 400.0 0\n"
             "P2_P3 EDDF LFPG A320 140200 140300 355 355 2 DLH4AB 240701 240701 3000.000000 1164.0 "
             "3000.000000 1176.0 1000 3 10.0 0\n"));
  const std::vector<Fix>& fixes = recording.bees.at(0).fixes;
  ASSERT_EQ(fixes.size(), 3u + 60u + 2u);
  double longest_s = 0.0;
  for (std::size_t i = 1; i < 63; ++i) {
    longest_s = std::max(longest_s, fixes[i].time_s - fixes[i - 1].time_s);
  }
  EXPECT_EQ(longest_s, 60.0);
  EXPECT_EQ(fixes[63].time_s - fixes[62].time_s, 3600.0);  // between two segments it is not known
  const Fix& middle = fixes[32];
  EXPECT_EQ(middle.time_s, 1719835320 + 1800);
  EXPECT_NEAR(middle.position.x, 13.4, 1e-9);
  EXPECT_NEAR(middle.position.y, 50.1549, 1e-4);
  for (const std::string& note : recording.notes) {
    EXPECT_EQ(note.find("repeat"), std::string::npos) << note;
  }
}

TEST(So6, ABadSegmentIsTold) {
  expect_error(record(kSegment + "P1_P2 EDDF LFPG A320 126000 120400 355\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:2", "is no segment of so6"});
}

}  // namespace
}  // namespace beespace::io
