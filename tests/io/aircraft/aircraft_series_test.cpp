// Documents of many aircraft, or aircraft, one a line; and the words of ADS-B Exchange.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

std::string heard_at(std::string_view hex, std::string_view lon, std::string_view more = {}) {
  std::string text = R"({"hex":")";
  return text.append(hex)
      .append(R"(","lat":47,"lon":)")
      .append(lon)
      .append(R"(,"alt_geom":10000,"gs":360,"track":90,"geom_rate":0,"seen_pos":0.5)")
      .append(more)
      .append("}");
}

std::string snapshot(std::string_view now, std::string_view aircraft,
                     std::string_view key = "aircraft") {
  return std::string(R"({"now":)")
      .append(now)
      .append(R"(,")")
      .append(key)
      .append(R"(":[)")
      .append(aircraft)
      .append("]}");
}

TEST(AircraftSeries, ASnapshotALine) {
  const auto recording = recording_of(
      record(snapshot("1700000000.5", heard_at("4b1814", "8") + "," + heard_at("3c6444", "9")) +
             "\n\n" + snapshot("1700000010.5", heard_at("4b1814", "8.02")) + "\n"));
  ASSERT_EQ(ids_of(recording), (std::vector<std::string>{"4b1814", "3c6444"}));
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1700000000.0, 1700000010.0}));
  EXPECT_EQ(recording.bees[0].fixes[1].position, (Point{8.02, 47, 3048}));
  EXPECT_EQ(recording.heights, HeightDatum::kEllipsoid);
  EXPECT_EQ(recording.format_description, "aircraft.json of readsb or dump1090");
}

TEST(AircraftSeries, AnAircraftALine) {
  const auto recording =
      recording_of(record(heard_at("4b1814", "8", R"(,"now":1700000000.5)") + "\n" +
                          heard_at("4b1814", "8.02", R"(,"now":1700000010.5)") + "\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1700000000.0, 1700000010.0}));
}

// dump1090-mutability has other words for the height by pressure, the speed and the climb.
TEST(AircraftSeries, WordsOfOlderDecoders) {
  const auto heard = [](std::string_view lon, std::string_view more) {
    return std::string(R"({"hex":"4b1814","lat":47,"lon":)")
        .append(lon)
        .append(R"(,"altitude":10000,"speed":360,"track":90,"vert_rate":600,"seen_pos":0.5)")
        .append(more)
        .append("}");
  };
  constexpr std::string_view kOfDecoder = R"(,"messages":100,"seen":0.1,"rssi":-20)";
  RecordingOptions pressure;
  pressure.heights = HeightSource::kRatherPressure;
  const auto recording =
      recording_of(record(snapshot("1700000000.5", heard("8", kOfDecoder)) + "\n" +
                              snapshot("1700000010.5", heard("8.02", kOfDecoder)) + "\n",
                          pressure));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes[1].position, (Point{8.02, 47, 3048}));
  EXPECT_EQ(recording.heights, HeightDatum::kPressure);
  EXPECT_EQ(recording.bees[0].velocities[1].z, 3.048);
  EXPECT_NEAR(recording.bees[0].velocities[1].x, 185.2, 1e-9);
  // Another sender may mean metres.
  const auto other = record(snapshot("1700000000.5", heard("8", "")) + "\n" +
                                snapshot("1700000010.5", heard("8.02", "")) + "\n",
                            pressure);
  EXPECT_FALSE(other.has_value());
}

TEST(AircraftSeries, StatesOfOpenSkyALine) {
  const std::string state =
      R"(["4b1814","SWR1    ","Switzerland",1700000000,1700000000,8.0,47.0,3000,false,100,90,0,)"
      R"(null,3100,null,false,0])";
  const auto recording = recording_of(record(R"({"time":1700000000,"states":[)" + state + "]}\n" +
                                             R"({"time":1700000001,"states":null})" + "\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes[0].position.z, 3100.0);
}

TEST(AircraftSeries, AdsbExchangeCountsMillisecondsAndListsAc) {
  for (const std::string& text :
       {snapshot("1700000000500", heard_at("4b1814", "8"), "ac"),
        snapshot("1700000000500", heard_at("4b1814", "8"), "ac") + "\n" +
            snapshot("1700000010500", heard_at("4b1814", "8.02"), "ac")}) {
    const auto recording = recording_of(record(text));
    ASSERT_EQ(recording.bees.size(), 1u);
    EXPECT_EQ(times_of(recording.bees[0])[0], 1700000000.0);
  }
}

TEST(AircraftSeries, HeightsOfTwoKindsAreNotMixedFromLineToLine) {
  const std::string baro = R"({"hex":"4b1814","lat":47,"lon":8.02,"alt_baro":9000,"seen_pos":0.5})";
  const auto recording = recording_of(record(snapshot("1700000000.5", heard_at("4b1814", "8")) +
                                             "\n" + snapshot("1700000010.5", baro) + "\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes.size(), 1u);
  EXPECT_TRUE(has_note(recording, "1 record without a height above the ellipsoid is left out"));
  EXPECT_EQ(recording.missing.count, 1u);
}

TEST(AircraftSeries, WhatIsWrongIsNamedWithItsLine) {
  const std::string good = snapshot("1700000000.5", heard_at("4b1814", "8")) + "\n";
  expect_error(record(good + snapshot("1700000010.5", heard_at("4b1814", "\"east\"")) + "\n"),
               {ErrorCode::kNotANumber, "bees.csv:2", "aircraft[0] ('4b1814'): 'lon' is a string"});
  expect_error(record(good + R"({"aircraft":[]})" + "\n"),
               {ErrorCode::kMissingColumn, "bees.csv:2", "there is no 'now'"});
  expect_error(record(good + R"({"planes":[]})" + "\n"),
               {ErrorCode::kUnsupportedFormat, "bees.csv:2", "no list of aircraft"});
  expect_error(record(good + R"({"now":1700000010.5,"aircraft":[)" + "\n"),
               {ErrorCode::kTruncated, "bees.csv:2:33", "each object must be whole in one line"});
  const auto skipping =
      recording_of(record(good + R"({"planes":[]})" + "\n" +
                              snapshot("1700000010.5", heard_at("4b1814", "8.02")) + "\n",
                          skipping_bad()));
  EXPECT_EQ(skipping.skipped_count, 1u);
  EXPECT_EQ(skipping.bees[0].fixes.size(), 2u);
}

}  // namespace
}  // namespace beespace::io
