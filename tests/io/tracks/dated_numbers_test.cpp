// Several columns of times in numbers, of which one counts from 1970.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

// ulog2csv of vehicle_gps_position: two count from the boot.
TEST(DatedNumbers, TheTimeOfSatellitesIsTakenBeforeTwoOfABoot) {
  const auto recording = recording_of(
      record("timestamp,timestamp_sample,latitude_deg,longitude_deg,altitude_msl_m,time_utc_usec\n"
             "100000000,100000000,47.3,8.5,530,1750000000000000\n"
             "100200000,100200000,47.3,8.5001,530,1750000000200000\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1750000000.0, 1750000000.2}));
  EXPECT_TRUE(recording.since_1970);
}

// A boot half an hour ago, in microseconds, looks like 2025 in seconds.
TEST(DatedNumbers, AUnitInTheNameTellsMoreThanTheSize) {
  const auto recording = recording_of(
      record("timestamp,timestamp_sample,latitude_deg,longitude_deg,altitude_msl_m,time_utc_usec\n"
             "1750000000,1750000000,47.3,8.5,530,1760000000000000\n"));
  EXPECT_EQ(times_of(recording.bees[0]), std::vector<double>{1760000000.0});
}

TEST(DatedNumbers, ATimeSince1970IsTakenBeforeOneOfABoot) {
  for (const std::string boot : {"TimeUS", "time_boot_ms", "time_boot_us"}) {
    const auto recording = recording_of(record("timestamp," + boot +
                                               ",lat,lon,alt_m\n1750000000.0,100000000,47,8,530\n"
                                               "1750000000.5,100500000,47,8.001,530\n"));
    ASSERT_EQ(recording.bees.size(), 1u) << boot;
    EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1750000000.0, 1750000000.5}));
  }
}

// Both may be right, or one be when it was measured.
TEST(DatedNumbers, TwoOfOneMomentAreAskedAbout) {
  expect_error(record("timestamp,time_ms,lat,lon,alt_m\n1750000000.0,1750000000000,47,8,530\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "look like the time; say which"});
}

}  // namespace
}  // namespace beespace::io
