// BaseStation (SBS-1) messages: units, velocities joined to positions, times, what is wrong.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;
using Times = std::vector<double>;

// A message at that time on the first of May 2024; `rest` is everything from the callsign on.
std::string message(char kind, std::string_view hex, std::string_view time, std::string_view rest) {
  std::string line = "MSG,";
  line.append(1, kind).append(",1,1,").append(hex).append(",1,2024/05/01,").append(time);
  return line.append(",2030/01/01,00:00:00.000,").append(rest).append("\r\n");
}

std::string airborne(std::string_view hex, std::string_view time, std::string_view lon = "8.5") {
  return message('3', hex, time, ",10000,,,47.25," + std::string(lon) + ",,,0,0,0,0");
}

std::string velocity(std::string_view hex, std::string_view time) {
  return message('4', hex, time, ",,360,270,,,-600,,0,0,0,0");
}

TEST(BaseStation, UnitsOfAviationBecomeMetresAndSeconds) {
  const auto recording =
      recording_of(record(message('1', "4B1814", "11:59:59.000", "SWR12AB ,,,,,,,,0,0,0,0") +
                          velocity("4B1814", "11:59:59.500") + airborne("4B1814", "12:00:00.250")));
  ASSERT_EQ(ids_of(recording), Ids{"4b1814"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.label, "SWR12AB");
  EXPECT_EQ(times_of(bee), Times{1714564800.25});
  EXPECT_EQ(bee.fixes[0].position, (Point{8.5, 47.25, 10000 * 0.3048}));
  EXPECT_NEAR(bee.velocities[0].x, -185.2, 1e-12);
  EXPECT_EQ(bee.velocities[0].y, 0.0);
  EXPECT_NEAR(bee.velocities[0].z, -3.048, 1e-15);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.heights, HeightDatum::kPressure);
  EXPECT_EQ(recording.format_description, "BaseStation messages");
  EXPECT_TRUE(has_note(recording, "times are taken for UTC"));
}

// Receivers write the time of the place where they are.
TEST(BaseStation, TimesAreOfTheZoneThatTheCallerSays) {
  RecordingOptions options;
  const auto paris = TimeZone::find("Europe/Paris");
  ASSERT_TRUE(paris);
  options.time_zone = *paris;
  const auto recording = recording_of(record(airborne("4B1814", "12:00:00.250"), options));
  EXPECT_EQ(times_of(recording.bees[0]), Times{1714564800.25 - 7200.0});
  EXPECT_TRUE(has_note(recording, "times are those of Europe/Paris, as --time-zone says"));
}

// As what records it is stopped.
TEST(BaseStation, ALastLineThatIsCutIsCounted) {
  const std::string all = airborne("A", "12:00:00.000") + airborne("A", "12:00:01.000");
  for (const std::size_t cut : {std::size_t{1}, std::size_t{12}, std::size_t{50}}) {
    const std::string more = airborne("B", "12:00:01.500").substr(0, cut);
    const Recording recording = recording_of(record(all + more));
    EXPECT_EQ(ids_of(recording), Ids{"a"}) << cut;
    EXPECT_EQ(recording.missing.count, 1u) << cut;
    EXPECT_TRUE(has_note(recording, "1 record cut short at the end of the input is left out"));
    // Elsewhere it is a mistake.
    EXPECT_FALSE(record(all + more + "\n" + all)) << cut;
  }
  EXPECT_TRUE(recording_of(record(all.substr(0, all.size() - 2))).missing.none());
}

// As mlat-client writes them.
TEST(BaseStation, PlacesByMultilaterationAreMessagesToo) {
  std::string found = airborne("A", "12:00:01.000", "8.501");
  ASSERT_EQ(found.substr(0, 4), "MSG,");
  found.replace(0, 3, "MLAT");
  const Recording recording = recording_of(record(airborne("A", "12:00:00.000") + found));
  EXPECT_EQ(recording.bees.at(0).fixes.size(), 2u);
  EXPECT_TRUE(recording.missing.none());
}

TEST(BaseStation, VelocitiesAreJoinedByAddressWhileTheyAreFresh) {
  const auto recording =
      recording_of(record(velocity("A", "12:00:00.000") + airborne("B", "12:00:01.000") +
                          airborne("A", "12:00:10.000") + airborne("A", "12:00:10.001", "8.6")));
  ASSERT_EQ(ids_of(recording), (Ids{"b", "a"}));
  EXPECT_TRUE(std::isnan(recording.bees[0].velocities[0].x));
  EXPECT_FALSE(std::isnan(recording.bees[1].velocities[0].x));
  EXPECT_TRUE(std::isnan(recording.bees[1].velocities[1].x));
}

TEST(BaseStation, AircraftOnTheGroundAreLeftOutUnlessAskedFor) {
  const std::string text = airborne("A", "12:00:00.000") +
                           message('2', "B", "12:00:00.000", ",0,5,90,47,8,,,0,0,0,-1") +
                           message('3', "C", "12:00:00.000", ",1300,,,47,8,,,0,0,0,-1");
  const auto flying = recording_of(record(text));
  EXPECT_EQ(ids_of(flying), Ids{"a"});
  EXPECT_TRUE(has_note(flying, "2 records of aircraft on the ground are left out"));
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_EQ(ids_of(recording_of(record(text, grounded))), (Ids{"a", "b", "c"}));
}

TEST(BaseStation, IncompleteRecordsAreLeftOut) {
  const auto recording = recording_of(record(
      airborne("A", "12:00:00.000") + message('3', "A", "12:00:01.000", ",10000,,,,,,,,,,0") +
      message('3', "A", "12:00:02.000", ",,,,47,8,,,0,0,0,0") +
      "MSG,3,1,1,A,1,,,,,,10000,,,47,8,,,0,0,0,0\n"));
  EXPECT_EQ(recording.bees[0].fixes.size(), 1u);
  EXPECT_TRUE(has_note(recording, "1 record without a position is left out"));
  EXPECT_TRUE(has_note(recording, "1 record without a height by pressure is left out"));
  EXPECT_TRUE(has_note(recording, "1 record without the time of the position is left out"));
}

TEST(BaseStation, OtherMessagesSayNothing) {
  const auto recording = recording_of(
      record("SEL,,496,2286,4CA4E5,27215,2010/02/19,18:06:07.710,2010/02/19,18:06:07.710,RYR1427\n"
             "\nID,,496,7162,405637,27928,2010/02/19,18:06:07.115,2010/02/19,18:06:07.115,EZY691A\n"
             "STA,,5,179,400AE7,10103,2008/11/28,14:58:51.153,2008/11/28,14:58:51.153,RM\n" +
             message('8', "A", "12:00:00.000", ",,,,,,,,,,,0") + airborne("A", "12:00:00.000")));
  EXPECT_EQ(ids_of(recording), Ids{"a"});
}

TEST(BaseStation, HeightsAreByPressureOnly) {
  RecordingOptions options;
  options.heights = HeightSource::kGeometric;
  expect_error(record(airborne("A", "12:00:00.000"), options),
               {ErrorCode::kInvalidArgument, "bees.csv", "heights by pressure only"});
  options.heights = HeightSource::kPressure;
  EXPECT_EQ(recording_of(record(airborne("A", "12:00:00.000"), options)).bees.size(), 1u);
}

TEST(BaseStation, WhatIsWrongIsBlamedOnLineAndField) {
  const std::string good = airborne("A", "12:00:00.000");
  for (const auto& [bad, code, place, message] :
       std::vector<std::tuple<std::string, ErrorCode, std::string, std::string>>{
           {"MSG,3,1,1\n", ErrorCode::kColumnCount, "bees.csv:2", "22 fields, this one has 4"},
           {"hello\n", ErrorCode::kMalformedRecord, "bees.csv:2:1", "'hello' is no BaseStation"},
           {message('9', "A", "12:00:00.000", ",,,,,,,,,,,0"), ErrorCode::kMalformedRecord,
            "bees.csv:2:2", "'9' is no kind of message"},
           {message('3', "", "12:00:00.000", ",,,,,,,,,,,0"), ErrorCode::kMalformedRecord,
            "bees.csv:2:5", "no address"},
           {airborne("A", "25:00:00.000"), ErrorCode::kNotANumber, "bees.csv:2:7",
            "is no date and time"},
           {message('3', "A", "12:00:00.000", ",high,,,47,8,,,0,0,0,0"), ErrorCode::kNotANumber,
            "bees.csv:2:12", "'high'"},
           {message('3', "A", "12:00:00.000", ",1e40,,,47,8,,,0,0,0,0"), ErrorCode::kOutsideDomain,
            "bees.csv:2:12", "'1e40' cannot be computed with"},
           {message('3', "A", "12:00:00.000", ",100,,,nan,8,,,0,0,0,0"), ErrorCode::kNotFinite,
            "bees.csv:2:15", "'nan'"},
           {message('3', "A", "12:00:00.000", ",100,,,97,8,,,0,0,0,0"), ErrorCode::kInvalidLatitude,
            "bees.csv:2", "latitude 97"}}) {
    expect_error(record(good + bad), {code, place, message});
    const auto skipping = recording_of(record(good + bad, skipping_bad()));
    EXPECT_EQ(skipping.skipped_count, 1u) << bad;
    EXPECT_EQ(ids_of(skipping), Ids{"a"}) << bad;
  }
}

TEST(BaseStation, ATableWhoseFirstColumnIsCalledIdIsATable) {
  const auto recording = recording_of(record("ID,time_s,x,y,z\na,0,1,2,3\n"));
  EXPECT_EQ(recording.format_description, "text, comma-separated");
}

}  // namespace
}  // namespace beespace::io
