// Flights that Flightradar24 exports as CSV, and what its feed answers with.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

const std::string kFlightHeader = "Timestamp,UTC,Callsign,Position,Altitude,Speed,Direction\n";

TEST(Flightradar24, AFlightIsReadAsItIsExported) {
  const auto recording = recording_of(
      record(kFlightHeader +
             "1719835206,2024-07-01T12:00:06Z,BAW9,\"50.500000,9.730743\",36000,450,270\n"
             "1719835221,2024-07-01T12:00:21Z,BAW9,\"50.500000,9.682126\",36000,450,270\n"));
  ASSERT_EQ(ids_of(recording), std::vector<std::string>{"BAW9"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.fixes.at(0), (Fix{1719835206, {9.730743, 50.5, 10972.8}}));
  EXPECT_EQ(bee.stated_heights.at(0), 36000.0);
  EXPECT_NEAR(bee.velocities.at(0).x, -450.0 * 1852.0 / 3600.0, 1e-9);
  EXPECT_EQ(recording.heights, HeightDatum::kPressure);
  EXPECT_EQ(recording.height_unit, Unit::kFoot);
  EXPECT_TRUE(recording.of_aircraft);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_TRUE(recording.missing.none());
}

// Which receiver heard it changes on the way.
TEST(Flightradar24, AFileOfTheDataServiceIsOneFlightWhicheverRadarHeardIt) {
  const auto recording =
      recording_of(record("snapshot_id,altitude,heading,latitude,longitude,radar_id,speed,squawk\n"
                          "1656324000,35000,88,46.98544,6.17404,1234,450,0\n"
                          "1656324015,35000,88,46.98616,6.21968,5010,450,0\n"));
  ASSERT_EQ(ids_of(recording), std::vector<std::string>{"bees"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.fixes.at(0), (Fix{1656324000, {6.17404, 46.98544, 10668.0}}));
  EXPECT_EQ(bee.stated_heights.at(0), 35000.0);
  EXPECT_NEAR(std::hypot(bee.velocities.at(0).x, bee.velocities.at(0).y), 450.0 * 1852.0 / 3600.0,
              1e-9);
  EXPECT_EQ(recording.heights, HeightDatum::kPressure);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_TRUE(recording.of_aircraft);
}

TEST(Flightradar24, AHeightOfZeroIsOfTheGroundOrOfNone) {
  const auto recording = recording_of(
      record(kFlightHeader + "1719835206,2024-07-01T12:00:06Z,BAW9,\"50.5,9.73\",0,12,270\n" +
             "1719835806,2024-07-01T12:10:06Z,BAW9,\"50.5,9.68\",36000,450,270\n"
             "1719835821,2024-07-01T12:10:21Z,BAW9,\"50.5,9.63\",0,450,270\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(times_of(recording.bees[0]), std::vector<double>{1719835806});
  EXPECT_TRUE(has_note(recording, "1 record of aircraft on the ground is left out"));
  EXPECT_TRUE(has_note(recording, "1 record without a height by pressure is left out"));
  EXPECT_EQ(recording.missing.count, 1u);
}

TEST(Flightradar24, AHeightOfZeroOnTheGroundIsKeptWhereThatIsAskedFor) {
  RecordingOptions grounded;
  grounded.grounded = true;
  const auto recording = recording_of(
      record(kFlightHeader + "1719835206,2024-07-01T12:00:06Z,BAW9,\"50.5,9.73\",0,12,270\n" +
                 "1719835221,2024-07-01T12:00:21Z,BAW9,\"50.5,9.63\",0,450,270\n",
             grounded));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes, (std::vector<Fix>{{1719835206, {9.73, 50.5, 0.0}}}));
  EXPECT_EQ(recording.missing.count, 1u);  // who flies has no height there
}

TEST(Flightradar24, WhatIsNoPlaceIsTold) {
  expect_error(
      record(kFlightHeader + "1719835207,2024-07-01T12:00:07Z,BAW9,\"50.5,east\",36000,450,270\n"),
      {ErrorCode::kNotANumber, "bees.csv:2:4", "'east' is not a number (longitude)"});
  const auto half = recording_of(
      record(kFlightHeader + "1719835206,2024-07-01T12:00:06Z,BAW9,50.5,36000,450,270\n"
                             "1719835221,2024-07-01T12:00:21Z,BAW9,\"50.5,9.6\",36000,450,270\n"));
  EXPECT_EQ(times_of(half.bees.at(0)), std::vector<double>{1719835221});
  EXPECT_EQ(half.missing.count, 1u);
}

constexpr std::string_view kFlightOfFeed =
    R"("35e4a1b0": ["3C6444", 50.0, 7.8, 90, 35000, 450, "1000", "F-EDDF1", "A320", "D-AIXX",
    1719835450, "FRA", "MUC", "LH123", 0, -600, "DLH4AB", 0, "DLH"])";

TEST(Flightradar24, TheFeedIsRead) {
  const auto recording = recording_of(record(
      R"({"full_count": 12000, "version": 4, )" + std::string(kFlightOfFeed) +
      R"(, "35e4a1b1": ["", 50.1, 7.8, 90, 0, 450, "", "", "", "", 1719835450, "", "", "", 0, 0,
      "RYR1", 0, "RYR"], "35e4a1b2": ["4CA7B5", 50.1, 7.8, 90, 0, 10, "", "", "", "", 1719835450,
      "", "", "", 1, 0, "RYR2", 0, "RYR"]})"));
  ASSERT_EQ(ids_of(recording), std::vector<std::string>{"3c6444"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.label, "DLH4AB");
  EXPECT_EQ(bee.fixes.at(0), (Fix{1719835450, {7.8, 50.0, 10668.0}}));
  EXPECT_NEAR(bee.velocities.at(0).z, -3.048, 1e-12);
  EXPECT_TRUE(has_note(recording, "1 record without a height by pressure is left out"));
  EXPECT_TRUE(has_note(recording, "1 record of aircraft on the ground is left out"));
  EXPECT_EQ(recording.missing.bees, 1u);
}

}  // namespace
}  // namespace beespace::io
