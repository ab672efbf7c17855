// Tracks of one aircraft: traces of readsb, tracks of OpenSky; and chunks of tar1090.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Flights = std::vector<std::string>;

RecordingOptions traces_by_pressure() {
  RecordingOptions options;
  options.heights = HeightSource::kPressure;
  return options;
}

const std::string kTrace =
    R"({"icao": "4B1812", "timestamp": 1714564800.5, "trace": [)"
    R"([0.0, 47.25, 8.5, 34400, 360.0, 90.0, 0, 600, {"flight": "SWR45   "}, "adsb_icao", 34700],)"
    R"([5.0, 47.25, 8.51, null, 360.0, 90.0, 0, null, null, "adsb_icao", null],)"
    R"([10.0, 47.25, 8.52, 34700, 360.0, 90.0, 8, 600, null, "adsb_icao", null],)"
    R"([20.0, 47.25, 8.53, "ground", 10.0, 90.0, 0, null, null, "adsb_icao", null]]})";

TEST(AircraftTrace, OfReadsbIsReadByItsPlaces) {
  const auto recording = recording_of(record(kTrace));
  ASSERT_EQ(ids_of(recording), Flights{"4b1812"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.label, "SWR45");
  EXPECT_EQ(times_of(bee), (std::vector<double>{1714564800.5, 1714564810.5}));
  EXPECT_EQ(bee.stated_heights, (std::vector<double>{34700, 34700}));
  EXPECT_NEAR(bee.velocities[0].x, 185.2, 1e-9);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(recording.format_description, "trace of readsb");
  EXPECT_TRUE(has_note(recording, "1 record of aircraft on the ground is left out"));
  const auto pressure = recording_of(record(kTrace, traces_by_pressure()));
  EXPECT_EQ(pressure.bees[0].stated_heights, std::vector<double>{34400});
  EXPECT_NEAR(pressure.bees[0].velocities[0].z, 3.048, 1e-9);
}

TEST(AircraftTrace, OfOpenSkyIsReadByItsPlaces) {
  const auto recording =
      recording_of(record(R"({"icao24": "3c6444", "callsign": "DLH123  ", "startTime": 1714564800,)"
                          R"("endTime": 1714564815, "path": [[1714564800, 48.0, 2.0, 10668, 90.0,)"
                          R"(false], [1714564815, 48.0, 2.05, 10668, 90.0, false]]})",
                          traces_by_pressure()));
  ASSERT_EQ(ids_of(recording), Flights{"3c6444"});
  EXPECT_EQ(recording.bees[0].label, "DLH123");
  EXPECT_EQ(recording.bees[0].fixes[1], (Fix{1714564815, {2.05, 48.0, 10668}}));
  EXPECT_EQ(recording.format_description, "track of OpenSky");
}

TEST(AircraftTrace, WhatIsWrongIsSaidWithItsPlace) {
  expect_error(record(R"({"icao": "4b1812", "trace": [[0, 47, 8, 100]]})"),
               {ErrorCode::kMissingColumn, "bees.csv", "there is no 'timestamp'"});
  expect_error(record(R"({"icao": "4b1812", "timestamp": 1714564800, "trace": [[0, 47, "x", 9]]})"),
               {ErrorCode::kNotANumber, "bees.csv", "trace[0] ('4b1812'): 'longitude'"});
  expect_error(record(R"({"icao": "4b1812", "timestamp": 1714564800, "trace": [[0, 47]]})"),
               {ErrorCode::kColumnCount, "bees.csv", "a time, a latitude, a longitude and more"});
}

TEST(AircraftTrace, ChunksHoldDocumentsOneAfterTheOther) {
  const auto part = [](const std::string& now, const std::string& longitude) {
    return R"({"now": )" + now + R"(, "messages": 1, "aircraft": [{"hex": "3c6444", "alt_geom": )" +
           R"(35300, "seen_pos": 0, "lat": 48.0, "lon": )" + longitude + "}]}";
  };
  const auto recording = recording_of(record(R"({"files": [)" + part("1714564800", "2.0") + "," +
                                             part("1714564830", "2.1") + "]}"));
  ASSERT_EQ(ids_of(recording), Flights{"3c6444"});
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1714564800, 1714564830}));
}

// tar1090 itself keeps lists of values, of which the height may be of either kind.
TEST(AircraftTrace, ChunksOfTar1090AreNamedForWhatTheyAre) {
  const std::string part =
      R"({"files": [{"now": 1714564800, "messages": 1, "aircraft": [["3c6444", 35000, 450, 90, 48.0, )"
      R"(2.0, 0.4, "adsb_icao", "DLH1    ", 12]]}]})";
  const std::string list = R"({"chunks": ["chunk_1.gz", "current_small.gz"]})";
  for (const std::string& chunk : {part, list}) {
    expect_error(record(chunk), {ErrorCode::kUnsupportedFormat, "bees.csv",
                                 "the chunks that tar1090 keeps to draw trails"});
  }
}

}  // namespace
}  // namespace beespace::io
