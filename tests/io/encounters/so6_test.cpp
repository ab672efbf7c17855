// Segments of so6: both ends are fixes, in minutes of arc and flight levels.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

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
  EXPECT_EQ(bee.fixes, (std::vector<Fix>{{1719835200, {7.025, 50.0, 10668.0}},
                                         {1719835320, {7.4, 50.0, 10820.4}},
                                         {1719835440, {7.8, 50.0, 10668.0}}}));
  EXPECT_EQ(bee.stated_heights, (std::vector<double>{35000, 35500, 35000}));
  EXPECT_EQ(recording.heights, HeightDatum::kPressure);
  EXPECT_EQ(recording.format_description, "segments of so6");
}

TEST(So6, ABadSegmentIsTold) {
  expect_error(record(kSegment + "P1_P2 EDDF LFPG A320 126000 120400 355\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:2", "is no segment of so6"});
}

}  // namespace
}  // namespace beespace::io
