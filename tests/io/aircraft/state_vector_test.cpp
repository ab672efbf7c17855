// State vectors of OpenSky: SI units, nulls, what is left out.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;

std::string file_of(std::string_view states) {
  return R"({"time": 1714564805, "states": [)" + std::string(states) + "]}";
}

constexpr std::string_view kFlying =
    R"(["4b1814","SWR12AB ","Switzerland",1714564800,1714564801,8.5,47.25,9000.5,false,200,180,)"
    R"(-3.25,null,9144,"1000",false,0])";
constexpr std::string_view kUnknown =
    R"(["a00001",null,"X",null,1714564801,null,null,null,false,null,null,null,null,null,null,)"
    R"(false,0])";

TEST(StateVectors, AreReadByTheirPlaces) {
  const auto recording = recording_of(record(file_of(kFlying)));
  ASSERT_EQ(ids_of(recording), Ids{"4b1814"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.label, "SWR12AB");
  EXPECT_EQ(bee.fixes[0], (Fix{1714564800, {8.5, 47.25, 9144}}));
  EXPECT_EQ(bee.velocities[0], (Velocity{0, -200, -3.25}));
  EXPECT_EQ(recording.heights, HeightDatum::kEllipsoid);
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(recording.format_description, "state vectors of OpenSky");
}

TEST(StateVectors, HeightsByPressureWhereTheyAreAskedFor) {
  RecordingOptions options;
  options.heights = HeightSource::kPressure;
  const auto recording = recording_of(record(file_of(kFlying), options));
  EXPECT_EQ(recording.bees[0].fixes[0].position.z, 9000.5);
  EXPECT_EQ(recording.heights, HeightDatum::kPressure);
}

TEST(StateVectors, NullsAreUnknown) {
  const std::string slow =
      R"(["b","","X",1714564800,1714564801,8.5,47.25,null,false,null,null,null,null,9144,null,)"
      R"(false,0])";
  const std::string timeless =
      R"(["c","","X",null,1714564801,8.5,47.25,null,false,null,null,null,null,9144,null,false,0])";
  const auto recording =
      recording_of(record(file_of(slow + "," + std::string(kUnknown) + "," + timeless)));
  ASSERT_EQ(ids_of(recording), Ids{"b"});
  EXPECT_TRUE(std::isnan(recording.bees[0].velocities[0].x));
  EXPECT_TRUE(std::isnan(recording.bees[0].velocities[0].z));
  EXPECT_EQ(recording.bees[0].label, "");
  EXPECT_TRUE(has_note(recording, "1 record without a position is left out"));
  EXPECT_TRUE(has_note(recording, "1 record without the time of the position is left out"));
}

TEST(StateVectors, AircraftOnTheGroundAreLeftOutUnlessAskedFor) {
  const std::string standing =
      R"(["b","","X",1714564800,1714564801,8.5,47.25,400,true,0,0,0,null,450,null,false,0,1])";
  const std::string text = file_of(std::string(kFlying) + "," + standing);
  EXPECT_EQ(ids_of(recording_of(record(text))), Ids{"4b1814"});
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_EQ(ids_of(recording_of(record(text, grounded))), (Ids{"4b1814", "b"}));
}

TEST(StateVectors, ASeriesIsMergedAndSaysTheSameSecondOnce) {
  const TemporaryFolder folder;
  const std::string later =
      R"(["4B1814","SWR12AB ","X",1714564810,1714564811,8.5,47.5,null,false,200,180,0,null,9144,)"
      R"(null,false,0])";
  const auto recording = recording_of(load_recording(
      {folder.write("1.json", file_of(kFlying)), folder.write("2.json", file_of(kFlying)),
       folder.write("3.json", R"({"time":1,"states":null})"),
       folder.write("4.json", file_of(later))}));
  ASSERT_EQ(ids_of(recording), Ids{"4b1814"});
  EXPECT_EQ(recording.bees[0].fixes.size(), 2u);
  EXPECT_TRUE(has_note(recording, "1 record repeats"));
}

TEST(StateVectors, WhatIsWrongIsBlamedOnTheRecord) {
  const std::string good = std::string(kFlying) + ",";
  for (const auto& [bad, code, message] :
       std::vector<std::tuple<std::string, ErrorCode, std::string>>{
           {R"(["a"])", ErrorCode::kColumnCount, "states[1]: it is an array"},
           {R"({})", ErrorCode::kColumnCount, "states[1]: it is an object"},
           {R"([1,"","X",1,1,8,47,1,false,1,1,1,null,1])", ErrorCode::kMalformedRecord,
            "its first value is no address"},
           {R"(["a","","X",1,1,"8",47,1,false,1,1,1,null,1])", ErrorCode::kNotANumber,
            "states[1] ('a'): 'longitude' is a string"},
           {R"(["a","","X",1,1,8,97,1,false,1,1,1,null,1])", ErrorCode::kInvalidLatitude,
            "latitude 97"}}) {
    const auto loaded = record(file_of(good + bad));
    expect_error(loaded, {code, "bees.csv", message});
    if (!loaded) {
      EXPECT_EQ(loaded.error().location.record, 1u) << bad;
    }
    EXPECT_EQ(recording_of(record(file_of(good + bad), skipping_bad())).skipped_count, 1u) << bad;
  }
}

TEST(StateVectors, AnEmptyListIsNoRecording) {
  expect_error(record(R"({"time":1,"states":null})"),
               {ErrorCode::kNoPoints, "bees.csv", "no bee is left"});
  expect_error(record(R"({"time":1,"states":"none"})"),
               {ErrorCode::kMalformedRecord, "bees.csv", "'states' is a string where a list"});
}

}  // namespace
}  // namespace beespace::io
