// Logs of gliders in the format of the IGC: fixes, days, heights, and what is not known.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

const std::string kHead = "AXXXABC FLIGHT:1\r\nHFDTE300624\r\nHFGIDGLIDERID:D-1234\r\n";

Result<Recording> igc(const std::string& text, const RecordingOptions& options = {}) {
  return load_recording_from_memory(text, "flights/anna.igc", options);
}

TEST(IgcLog, TellsFixesInUtcWithBothHeights) {
  const std::string text = kHead +
                           "I023638FXA3940SIU\r\n"
                           "B2359584730300N00730000EA015000156000308\r\n"
                           "B0000024730600S00730000WA-0010-0012000308\r\nGABCDEF\r\n";
  const auto geometric = recording_of(igc(text));
  ASSERT_EQ(ids_of(geometric), std::vector<std::string>{"anna"});
  const RecordedBee& bee = geometric.bees[0];
  EXPECT_EQ(bee.label, "D-1234");
  ASSERT_EQ(bee.fixes.size(), 2u);
  EXPECT_EQ(bee.fixes[0].time_s, 1719791998.0);  // 2024-06-30T23:59:58Z
  EXPECT_NEAR(bee.fixes[0].position.y, 47.505, 1e-12);
  EXPECT_NEAR(bee.fixes[0].position.x, 7.5, 1e-12);
  EXPECT_EQ(bee.fixes[0].position.z, 1560.0);
  // The next day.
  EXPECT_EQ(bee.fixes[1].time_s, 1719792002.0);
  EXPECT_NEAR(bee.fixes[1].position.y, -47.51, 1e-12);
  EXPECT_NEAR(bee.fixes[1].position.x, -7.5, 1e-12);
  EXPECT_EQ(bee.fixes[1].position.z, -12.0);
  EXPECT_EQ(geometric.heights, HeightDatum::kEllipsoid);
  EXPECT_TRUE(geometric.of_aircraft);
  EXPECT_EQ(geometric.format_description, "IGC log");
  RecordingOptions options;
  options.heights = HeightSource::kPressure;
  const auto pressure = recording_of(igc(text, options));
  EXPECT_EQ(pressure.bees[0].fixes.at(0).position.z, 1500.0);
  EXPECT_EQ(pressure.heights, HeightDatum::kPressure);
}

TEST(IgcLog, WithoutAFixInSpaceItIsNotKnownWhereTheGliderIs) {
  const auto recording = recording_of(
      igc("AXXXABC\nHFDTEDATE:010724,01\nB1200004730300N00730000EA0150001560\n"
          "B1200044730300N00730000EV0150000000\nB1200084730300N00730000EA0150001560\n"));
  EXPECT_EQ(times_of(recording.bees.at(0)), (std::vector<double>{1719835200, 1719835208}));
  EXPECT_EQ(recording.missing.count, 1u);
  EXPECT_TRUE(has_note(recording, "1 record without a fix in three dimensions (V) is left out"));
}

TEST(IgcLog, HeightsThatAreZeroThroughoutAreNone) {
  const std::string text =
      "AXXXABC\nHFDTE010724\nB1200004730300N00730000EA0150000000\n"
      "B1200044730300N00730000EA0150000000\n";
  expect_error(igc(text), {ErrorCode::kNoPoints, "flights/anna.igc",
                           "2 records without a height above the ellipsoid are left out"});
}

// A fix a minute, of which the first ones and the last ones are at one place.
std::string parked(int minutes, int moves_thousandths) {
  std::string text = "AXXXABC\nHFDTE010724\n";
  for (int minute = 0; minute < 2 * minutes + 20; ++minute) {
    const int flown = std::min(std::max(minute - minutes, 0), 20);
    const bool stands = flown == 0 || flown == 20;
    const int thousandths = flown * 500 + (minute % 2) * (stands ? moves_thousandths : 0);
    std::array<char, 60> line{};
    std::snprintf(line.data(), line.size(), "B12%02d00473%04dN00730000EA%05d%05d\n", minute,
                  thousandths % 10'000, stands ? 500 : 1500, stands ? 560 : 1560);
    text += line.data();
  }
  return text;
}

// What stands for minutes where its log begins, or ends, is on the ground; nothing else tells it.
TEST(IgcLog, WhoStandsForMinutesAtItsEndsIsOnTheGround) {
  const auto recording = recording_of(igc(parked(4, 5)));
  EXPECT_EQ(recording.bees.at(0).fixes.size(), 19u);
  EXPECT_TRUE(recording.missing.none());
  EXPECT_TRUE(has_note(recording, "9 records of aircraft on the ground"));
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_EQ(recording_of(igc(parked(4, 5), grounded)).bees.at(0).fixes.size(), 28u);
  // Two minutes at least, within 15 m.
  EXPECT_EQ(recording_of(igc(parked(1, 5))).bees.at(0).fixes.size(), 22u);
  EXPECT_EQ(recording_of(igc(parked(4, 20))).bees.at(0).fixes.size(), 28u);
}

TEST(IgcLog, WhatIsWrongIsTold) {
  const std::string fix = "B1200004730300N00730000EA0150001560\n";
  expect_error(igc("AXXXABC\n" + fix + "HFDTE010724\n"),
               {ErrorCode::kMissingColumn, "flights/anna.igc:2", "no line HFDTE before this fix"});
  expect_error(
      igc("AXXXABC\nHFDTE010724\nB1200004799300N00730000EA0150001560\n"),
      {ErrorCode::kMalformedRecord, "flights/anna.igc:3", "is no fix of a log of the IGC"});
  expect_error(igc("AXXXABC\nHFDTE991324\n" + fix),
               {ErrorCode::kMalformedRecord, "flights/anna.igc:2", "tells no day"});
}

}  // namespace
}  // namespace beespace::io
