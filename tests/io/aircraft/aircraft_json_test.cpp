// aircraft.json of readsb and dump1090: every unit, what is left out, and a series of files.
#include <beespace/geodesy.hpp>

#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;
using Times = std::vector<double>;

std::string file_of(std::string_view aircraft, std::string_view now = "1000000.5") {
  return std::string(R"({"now": )") + std::string(now) + R"(, "messages": 7, "aircraft": [)" +
         std::string(aircraft) + "]}";
}

RecordingOptions by_pressure() {
  RecordingOptions options;
  options.heights = HeightSource::kPressure;
  return options;
}

constexpr std::string_view kFlying =
    R"({"hex":"4B1814","type":"adsb_icao","flight":"SWR12AB ","alt_baro":9000,"alt_geom":10000,)"
    R"("gs":360,"track":90,"geom_rate":600,"baro_rate":-1200,"lat":47.25,"lon":8.5,"seen_pos":2.5,)"
    R"("mlat":[],"seen":0.1})";

TEST(AircraftJson, UnitsOfAviationBecomeMetresAndSeconds) {
  const auto recording = recording_of(record(file_of(kFlying)));
  ASSERT_EQ(ids_of(recording), Ids{"4b1814"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.label, "SWR12AB");
  EXPECT_EQ(times_of(bee), Times{999998.0});
  EXPECT_EQ(bee.fixes[0].position, (Point{8.5, 47.25, 10000 * 0.3048}));
  ASSERT_EQ(bee.velocities.size(), 1u);
  EXPECT_NEAR(bee.velocities[0].x, 185.2, 1e-12);  // 360 knots due east
  EXPECT_EQ(bee.velocities[0].y, 0.0);
  EXPECT_NEAR(bee.velocities[0].z, 3.048, 1e-15);  // by satellites, as the height is
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.heights, HeightDatum::kEllipsoid);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(recording.format_description, "aircraft.json of readsb or dump1090");
  EXPECT_TRUE(has_note(recording, "geometric, above the WGS84 ellipsoid"));
}

TEST(AircraftJson, VelocitiesAreThoseOfTheLibrary) {
  const auto recording = recording_of(record(file_of(
      R"({"hex":"a","lat":1,"lon":2,"alt_geom":3,"seen_pos":0,"gs":433.5,"track":254.62})")));
  const LocalVelocity expected = local_velocity(433.5 * 1852.0 / 3600.0, 254.62, 0.0);
  EXPECT_EQ(recording.bees[0].velocities[0].x, expected.east_mps);
  EXPECT_EQ(recording.bees[0].velocities[0].y, expected.north_mps);
}

TEST(AircraftJson, HeightsByPressureForAllWhereTheyAreAskedFor) {
  const auto recording = recording_of(record(file_of(kFlying), by_pressure()));
  EXPECT_EQ(recording.bees[0].fixes[0].position.z, 2743.2);
  EXPECT_NEAR(recording.bees[0].velocities[0].z, -6.096, 1e-15);
  EXPECT_EQ(recording.heights, HeightDatum::kPressure);
  EXPECT_TRUE(has_note(recording, "by pressure"));
}

TEST(AircraftJson, HeightsOfTwoKindsAreNeverMixed) {
  const std::string geometric = R"({"hex":"a","lat":1,"lon":2,"alt_geom":100,"seen_pos":0})";
  const std::string pressure = R"({"hex":"b","lat":1,"lon":2,"alt_baro":100,"seen_pos":0})";
  const std::string both = file_of(geometric + "," + pressure);
  auto recording = recording_of(record(both));
  EXPECT_EQ(ids_of(recording), Ids{"a"});
  EXPECT_TRUE(has_note(recording,
                       "1 record without a height above the ellipsoid is left out; "
                       "--heights pressure"));
  recording = recording_of(record(both, by_pressure()));
  EXPECT_EQ(ids_of(recording), Ids{"b"});
  EXPECT_TRUE(has_note(recording, "1 record without a height by pressure is left out"));
}

TEST(AircraftJson, TheOtherRateServesWhereTheRightOneIsMissing) {
  const std::string text =
      file_of(R"({"hex":"a","lat":1,"lon":2,"alt_geom":3,"seen_pos":0,"gs":0,"track":0,)"
              R"("baro_rate":-600})");
  EXPECT_NEAR(recording_of(record(text)).bees[0].velocities[0].z, -3.048, 1e-15);
}

TEST(AircraftJson, WhatIsMissingOfTheVelocityIsUnknown) {
  const auto recording = recording_of(record(
      file_of(R"({"hex":"a","lat":1,"lon":2,"alt_geom":3,"seen_pos":0,"gs":100,"geom_rate":0},)"
              R"({"hex":"b","lat":1,"lon":2,"alt_geom":3,"seen_pos":0,"gs":null,"track":5},)"
              R"({"hex":"c","lat":1,"lon":2,"alt_geom":3,"seen_pos":0,"gs":100,"track":5})")));
  ASSERT_EQ(recording.bees.size(), 3u);
  EXPECT_TRUE(std::isnan(recording.bees[0].velocities[0].x));
  EXPECT_EQ(recording.bees[0].velocities[0].z, 0.0);
  EXPECT_TRUE(std::isnan(recording.bees[1].velocities[0].y));
  EXPECT_FALSE(std::isnan(recording.bees[2].velocities[0].x));
  EXPECT_TRUE(std::isnan(recording.bees[2].velocities[0].z));
}

TEST(AircraftJson, VelocitiesSmallerThanAnyMotionAreNone) {
  const auto recording = recording_of(record(file_of(
      R"({"hex":"a","lat":1,"lon":2,"alt_geom":3,"seen_pos":0,"gs":1e-29,"track":1e-29})")));
  EXPECT_EQ(recording.bees[0].velocities[0].x, 0.0);
}

TEST(AircraftJson, AircraftOnTheGroundAreLeftOutUnlessAskedFor) {
  const std::string text =
      file_of(R"({"hex":"a","lat":1,"lon":2,"alt_geom":3,"seen_pos":0},)"
              R"({"hex":"b","lat":1,"lon":2,"alt_geom":4,"alt_baro":"ground","seen_pos":0})");
  const auto flying = recording_of(record(text));
  EXPECT_EQ(ids_of(flying), Ids{"a"});
  EXPECT_TRUE(has_note(flying, "1 record of aircraft on the ground is left out; --grounded"));
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_EQ(ids_of(recording_of(record(text, grounded))), (Ids{"a", "b"}));
}

TEST(AircraftJson, WithoutPositionOrItsTimeTheyAreLeftOut) {
  const auto recording = recording_of(
      record(file_of(R"({"hex":"a","lat":1,"lon":2,"alt_geom":3,"seen_pos":0},{"hex":"b"},)"
                     R"({"hex":"c","lat":1},{"hex":"d","lat":1,"lon":2,"alt_geom":3})")));
  EXPECT_EQ(ids_of(recording), Ids{"a"});
  EXPECT_TRUE(has_note(recording, "2 records without a position are left out"));
  EXPECT_TRUE(has_note(recording, "1 record without the time of the position is left out"));
}

TEST(AircraftJson, WhenAllAreLeftOutTheErrorSaysWhy) {
  expect_error(
      record(file_of(R"({"hex":"b","lat":1,"lon":2,"alt_baro":100,"seen_pos":0},{"hex":"b"})")),
      {ErrorCode::kNoPoints, "bees.csv", "--heights pressure"});
  expect_error(record(file_of("")), {ErrorCode::kNoPoints, "bees.csv", "no bee is left"});
}

std::string seen(std::string_view hex, std::string_view lon, std::string_view ago) {
  std::string text = R"({"hex":")";
  return text.append(hex)
      .append(R"(","lat":1,"lon":)")
      .append(lon)
      .append(R"(,"alt_geom":3,"seen_pos":)")
      .append(ago)
      .append("}");
}

TEST(AircraftJson, ASeriesOfFilesIsOneRecordingMergedByAddress) {
  const TemporaryFolder folder;
  EXPECT_FALSE(folder.write("history_10.json", file_of(seen("a", "2.5", "0"), "1010")).empty());
  EXPECT_FALSE(folder
                   .write("history_2.json",
                          file_of(seen("A", "2.25", "1") + "," + seen("b", "7", "0.5"), "1002"))
                   .empty());
  EXPECT_FALSE(folder.write("history_1.json", file_of(seen("a", "2", "0.5"), "1001")).empty());
  const auto recording = recording_of(load_recording({folder.file("")}));
  ASSERT_EQ(ids_of(recording), (Ids{"a", "b"}));
  EXPECT_EQ(times_of(recording.bees[0]), (Times{1000.5, 1001, 1010}));
  EXPECT_EQ(recording.bees[0].fixes[1].position.x, 2.25);
}

TEST(AircraftJson, APositionThatIsWrittenAgainIsHeardOnce) {
  // Ages are rounded to tenths, and the height may be heard anew.
  const TemporaryFolder folder;
  const auto recording = recording_of(load_recording(
      {folder.write("1.json", file_of(seen("a", "2", "0.4"), "1001.2")),
       folder.write("2.json", file_of(R"({"hex":"a","lat":1,"lon":2,"alt_geom":25,"seen_pos":1.3})",
                                      "1002.2")),
       folder.write("3.json", file_of(seen("a", "3", "0.1"), "1003.2"))}));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes.size(), 2u);
  EXPECT_TRUE(has_note(recording, "1 record repeats"));
}

TEST(AircraftJson, TwoPlacesAtOneRoundedTimeAreNoConflict) {
  const TemporaryFolder folder;
  const auto recording = recording_of(
      load_recording({folder.write("1.json", file_of(seen("a", "2", "0"), "1001")),
                      folder.write("2.json", file_of(seen("a", "2.001", "1"), "1002"))}));
  EXPECT_EQ(recording.bees[0].fixes.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes[0].position.x, 2.0);
  EXPECT_TRUE(has_note(recording, "1 record says another place for a time"));
}

TEST(AircraftJson, WhatIsWrongIsBlamedOnTheRecord) {
  const std::string good = seen("a", "2", "0") + ",";
  for (const auto& [bad, code, message] :
       std::vector<std::tuple<std::string, ErrorCode, std::string>>{
           {R"({"lat":1})", ErrorCode::kMissingColumn, "aircraft[1]: there is no 'hex'"},
           {R"({"hex":7})", ErrorCode::kMalformedRecord, "aircraft[1]: 'hex' is no address"},
           {R"(5)", ErrorCode::kMalformedRecord, "aircraft[1]: it is a number"},
           {seen("b", "\"2\"", "0"), ErrorCode::kNotANumber,
            "aircraft[1] ('b'): 'lon' is a string where a number should be"},
           {R"({"hex":"b","alt_baro":"high"})", ErrorCode::kNotANumber, "'alt_baro' is a string"},
           {seen("b", "1e40", "0"), ErrorCode::kOutsideDomain, "'lon' cannot be computed with"},
           {seen("b", "400", "0"), ErrorCode::kInvalidLongitude, "longitude 400 is beyond 360"},
           {R"({"hex":"b","lat":-91,"lon":2,"alt_geom":3,"seen_pos":0})",
            ErrorCode::kInvalidLatitude, "latitude -91 is beyond 90 degrees"},
           {R"({"hex":"b","lat":1,"lon":2,"alt_geom":9e6,"seen_pos":0})", ErrorCode::kInvalidHeight,
            "is no height of a bee"}}) {
    const auto loaded = record(file_of(good + bad));
    expect_error(loaded, {code, "bees.csv", message});
    if (!loaded) {
      EXPECT_EQ(loaded.error().location.record, 1u) << bad;
    }
    const auto skipping = recording_of(record(file_of(good + bad), skipping_bad()));
    EXPECT_EQ(ids_of(skipping), Ids{"a"}) << bad;
    EXPECT_EQ(skipping.skipped_count, 1u) << bad;
  }
}

TEST(AircraftJson, WhatIsWrongWithTheWholeFile) {
  expect_error(record(R"({"aircraft": []})"),
               {ErrorCode::kMissingColumn, "bees.csv", "there is no 'now'"});
  expect_error(record(R"({"now": "noon", "aircraft": []})"),
               {ErrorCode::kNotANumber, "bees.csv", "'now' is a string"});
  expect_error(record(R"({"now": 1, "aircraft": {}})"),
               {ErrorCode::kMalformedRecord, "bees.csv", "'aircraft' is an object where a list"});
  expect_error(record(R"({"now": 1, "aircraft": [)"),
               {ErrorCode::kTruncated, "bees.csv:1:25", "ends too early"});
  expect_error(record(R"({"planes": []})"),
               {ErrorCode::kUnsupportedFormat, "bees.csv", "'aircraft' (readsb)"});
}

TEST(AircraftJson, OptionsOfTablesDoNotGoWithIt) {
  RecordingOptions options;
  options.frame = Frame::kMetres;
  expect_error(record(file_of(kFlying), options),
               {ErrorCode::kInvalidArgument, "bees.csv", "--crs metres"});
  expect_error(record(file_of(kFlying), columns_are("id=1", Unit::kUnstated)),
               {ErrorCode::kInvalidArgument, "bees.csv", "--columns"});
  expect_error(record(file_of(kFlying), columns_are("", Unit::kSecond)),
               {ErrorCode::kInvalidArgument, "bees.csv", "--time-unit"});
}

TEST(AircraftJson, FilesOfOtherHeightsAreNotReadTogether) {
  const TemporaryFolder folder;
  const std::string aircraft = folder.write("a.json", file_of(kFlying));
  const std::string messages =
      folder.write("b.sbs",
                   "MSG,3,1,1,ABCDEF,1,2024/05/01,12:00:00.250,2024/05/01,12:00:00.250,,"
                   "35000,,,46.5,7.5,,,0,0,0,0\n");
  expect_error(load_recording({aircraft, messages}),
               {ErrorCode::kInvalidArgument, messages, "heights here are by pressure"});
  EXPECT_EQ(recording_of(load_recording({aircraft, messages}, by_pressure())).bees.size(), 2u);
}

}  // namespace
}  // namespace beespace::io
