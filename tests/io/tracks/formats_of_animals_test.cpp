// Tables of animals under the headers of their tools: collars, tags of seals, videos, R.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;

const std::string kTelonics =
    "Telonics Data Report\n\nConverter,Telonics Data Converter\nCTN,712345A\nHeaders Row,8\n\n\n"
    "Acquisition Time,Acquisition Start Time,Iridium CEP Radius,GPS Fix Time,GPS Fix Attempt,GPS "
    "Latitude,GPS Longitude,GPS UTM Zone,GPS UTM Northing,GPS UTM Easting,GPS Altitude,GPS "
    "Horizontal Error,Activity Count,Error\n"
    "2024.08.01 00:00:40,2024.08.01 00:00:00,,2024.08.01 00:00:40,Succeeded,65.1,-148.2,6W,7212345,"
    "452345,240,8,34,\n"
    "2024.08.01 01:00:30,2024.08.01 01:00:00,,,Failed,,,,,,,,34,\n"
    "2024.08.01 02:00:40,2024.08.01 02:00:00,,2024.08.01 02:00:40,Succeeded,65.2,-148.2,6W,7212345,"
    "452345,240,8,34,\n";

TEST(FormatsOfAnimals, TelonicsIsRead) {
  const auto recording = recording_of(record(kTelonics));
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.bees[0].fixes.size(), 2U);
  // The time of the fix, and of the record without one that at which it was due.
  EXPECT_TRUE(has_note(recording, "column 4 'GPS Fix Time'"));
}

// A receiver may need a minute for a fix.
TEST(FormatsOfAnimals, TelonicsHasTheTimesOfItsFixes) {
  std::string report = "Converter,Telonics Data Converter\nTime Zone,UTC\nHeaders Row,5\n\n";
  report += kTelonics.substr(kTelonics.find("Acquisition Time"));
  const std::string due = "2024.08.01 02:00:40,2024.08.01 02:00:00,,2024.08.01 02:00:40";
  report.replace(report.find(due), due.size(),
                 "2024.08.01 02:00:00,2024.08.01 02:00:00,,2024.08.01 02:00:49");
  report += "2024.08.01 03:00:00,2024.08.01 03:00:00,,,Failed,,,,,,,,34,\n";
  report += "2024.08.01 04:00:00,2024.08.01 04:00:00,,,Failed,,,,,,,,34,\n";
  const auto recording = recording_of(record(report));
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_TRUE(has_note(recording, "those without a time zone are of UTC: a line above the header"));
  const auto times_s = times_of(recording.bees[0]);
  ASSERT_EQ(times_s.size(), 2U);
  EXPECT_EQ(times_s[1] - times_s[0], 2 * 3600.0 + 9.0);
  ASSERT_TRUE(recording.bees[0].unplaced_until_s);
  EXPECT_EQ(*recording.bees[0].unplaced_until_s - times_s[0], 4 * 3600.0 - 40.0);
}

// Inventa of Vectronic.
TEST(FormatsOfAnimals, VectronicTellsItsTimesInUtc) {
  const auto recording = recording_of(record(
      "\"Collar ID\",\"Acq. Time [UTC]\",\"Acq. Time [LMT]\",\"Latitude[deg]\",\"Longitude[deg]\","
      "\"Altitude[m]\",\"DOP\",\"Fix Type\"\n14101,2023-05-01 00:00:00,2023-05-01 "
      "02:00:00,47.5,9.0,"
      "430,1.4,3D-V Fix\n14101,2023-05-01 00:15:00,2023-05-01 02:15:00,47.5,9.0,430,1.4,3D-V "
      "Fix\n"));
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_EQ(times_of(recording.bees[0])[0], 1682899200.0);
}

// One question for both.
TEST(FormatsOfAnimals, FramesAndPixelsAreAskedForAtOnce) {
  expect_error(record("frame,bee_id,x_pixels,y_pixels\n0,1,5,5\n1,1,5,6\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:3",
                "say how long one is, as in --scale 0.1mm (--scale 1 takes it for a metre); and "
                "column 1 'frame' counts the frames of a video: say how many there are in a "
                "second, as in --fps 25"});
}

TEST(FormatsOfAnimals, LinesAboveTheHeaderAreAsManyAsTheySay) {
  std::string report = "TDC Version,2.50\n\nHeaders Row,24\nCTN,724101A\nTime Zone,UTC\n";
  for (int line = 6; line < 24; ++line) report += "Setting" + std::to_string(line) + ",x\n";
  const auto header = kTelonics.find("Acquisition Time");
  const auto recording = recording_of(record(report + kTelonics.substr(header)));
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_EQ(recording.bees[0].fixes.size(), 2U);
  // What is wrong is named by its line in the file.
  const auto bad = record(report + kTelonics.substr(header) + "2024.08.01 03:00:00,x\n");
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().location.line, 28u);
}

// Between two places of a tag there are records of its sensors.
TEST(FormatsOfAnimals, RecordsOfSensorsAreNoLostPlaces) {
  std::string table =
      "device_id,UTC_datetime,datatype,satcount,hdop,Latitude,Longitude,MSL_altitude_m,acc_x\n";
  for (int minute = 10; minute < 20; ++minute) {
    const std::string time = "24101,2023-05-01 00:" + std::to_string(minute);
    table += time + ":00,GPS,7,1.1,47.5001,9.0001,397,500\n";
    table += time + ":20,SENSORS,0,0.0,,,,500\n" + time + ":40,SENSORS,0,0.0,,,,500\n";
  }
  const auto recording = recording_of(record(table));
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_EQ(recording.bees[0].fixes.size(), 10U);
  EXPECT_TRUE(recording.bees[0].lost.empty());
  EXPECT_TRUE(recording.of_animals);
  EXPECT_TRUE(has_note(recording, "20 records of sensors alone"));
}

// Tags write accelerations between their places, which Movebank puts into the same table; a place
// that is missing in a record of GPS is missing.
TEST(FormatsOfAnimals, RecordsOfAccelerationAreNoLostPlaces) {
  for (const auto& [column, gps, acceleration] :
       {std::array<std::string, 3>{"sensor-type", "gps", "acceleration"},
        std::array<std::string, 3>{"sensor-type-id", "653", "2365683"}}) {
    std::string table = "timestamp,location-long,location-lat," + column +
                        ",individual-local-identifier,study-name\n";
    for (int minute = 10; minute < 20; ++minute) {
      const std::string time = "2024-05-03 00:" + std::to_string(minute);
      table += time;
      table += ":00.000,9.0001,47.5001," + gps + ",deer,s\n";
      for (const char* const second : {":20.000,,,", ":40.000,,,"}) {
        table += time;
        table += second;
        table += minute == 15 ? gps : acceleration;
        table += ",deer,s\n";
      }
    }
    const auto recording = recording_of(record(table));
    ASSERT_EQ(recording.bees.size(), 1U);
    EXPECT_EQ(recording.bees[0].fixes.size(), 10U);
    EXPECT_EQ(recording.bees[0].lost.size(), 1U) << column;
    EXPECT_TRUE(has_note(recording, "18 records of sensors alone"));
  }
}

const std::string kSeals =
    "DeployID,Ptt,Instr,Date,Type,Quality,Latitude,Longitude,Error radius,Error Semi-major axis,"
    "Error Semi-minor axis,Error Ellipse orientation,Offset,Offset orientation,GPE MSD,GPE "
    "U,Count,Comment\n"
    "seal0,170001,Mk10,00:00:00 15-Jan-2024,FastGPS,8,-54.0,-36.045,,,,,,,,,,\n"
    "seal0,170001,Mk10,00:30:00 15-Jan-2024,Argos,B,-54.0,-36.042,,,,,,,,,,\n"
    "seal1,170002,Mk10,00:00:00 15-Jan-2024,FastGPS,8,-54.1,-36.045,,,,,,,,,,\n";

TEST(FormatsOfAnimals, LocationsOfWildlifeComputersAreRead) {
  const auto recording = recording_of(record(kSeals));
  EXPECT_EQ(ids_of(recording), (Ids{"seal0", "seal1"}));
  constexpr double kMidnight_s = 1705276800.0;
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{kMidnight_s, kMidnight_s + 1800.0}));
  // By Doppler shifts it may be off by kilometres.
  EXPECT_TRUE(has_note(recording, "Argos"));
}

TEST(FormatsOfAnimals, MonthsMayHaveNames) {
  for (const std::string date :
       {"15-Jan-2024 07:00:00", "15 January 2024 07:00", "15/JAN/2024 07:00",
        "07:00:00 15-Jan-2024", "2024.01.15 07:00:00"}) {
    RecordingOptions options;
    options.time_zone = TimeZone::utc();
    const auto recording = recording_of(record("id,time,x_m,y_m\na," + date + ",1,2\n", options));
    ASSERT_EQ(recording.bees.size(), 1U) << date;
    EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1705302000.0})) << date;
  }
}

TEST(FormatsOfAnimals, AccelerationsOfAxyTrekAreNoPlaces) {
  const auto recording = recording_of(record(
      "TagID,Timestamp,X,Y,Z,Activity,location-lat,location-lon,height-above-msl,ground-speed\n"
      "S1,2024-07-13 04:00:00.000,0.012,-0.031,0.98,Active,42.7,10.38,3,12.1\n"
      "S1,2024-07-13 04:00:01.000,0.112,-0.031,0.98,Active,,,,\n"
      "S1,2024-07-13 04:00:02.000,0.112,-0.031,0.98,Active,42.7,10.39,3,12.1\n"));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_EQ(recording.bees[0].fixes.size(), 2U);
}

TEST(FormatsOfAnimals, AnimalTaHasColumnsForEach) {
  RecordingOptions options;
  options.pixel = StatedLength{0.001, 1.0, Unit::kMillimetre};
  const auto recording = recording_of(record(
      "Frame;Time;X_Arena0_Ind0;Y_Arena0_Ind0;X_Arena0_Ind1;Y_Arena0_Ind1\n"
      "0;0.00;100.0;100.0;300.0;110.0\n1;0.04;102.0;100.0;NA;NA\n2;0.08;104.0;100.0;296.0;110.0\n",
      options));
  ASSERT_EQ(ids_of(recording), (Ids{"Arena0_Ind0", "Arena0_Ind1"}));
  EXPECT_EQ(recording.bees[0].fixes[1].time_s, 0.04);
  EXPECT_DOUBLE_EQ(recording.bees[0].fixes[1].position.x, 0.102);
  EXPECT_EQ(recording.bees[1].fixes.size(), 2U);
  EXPECT_TRUE(has_note(recording, "as AnimalTA writes them"));
}

TEST(FormatsOfAnimals, PointsOfRAreSplit) {
  RecordingOptions options;
  options.frame = Frame::kWgs84;
  for (const std::string points :
       {"a,2024-07-01T08:00:00Z,POINT (-6.5 37.25)\na,2024-07-01T08:10:00Z,POINT EMPTY\n"
        "a,2024-07-01T08:20:00Z,POINT (-6.5 37.5)\n",
        "a,2024-07-01T08:00:00Z,\"c(-6.5, 37.25)\"\na,2024-07-01T08:10:00Z,\"c(NA, NA)\"\n"
        "a,2024-07-01T08:20:00Z,\"c(-6.5, 37.5)\"\n"}) {
    const auto recording = recording_of(record("id,timestamp,geometry\n" + points, options));
    ASSERT_EQ(recording.bees.size(), 1U);
    EXPECT_EQ(recording.bees[0].fixes.size(), 2U);
    EXPECT_TRUE(has_note(recording, "places are points in one cell"));
  }
  // Whether they are degrees is asked of numbers, as of other tables with x and y.
  expect_error(record("id,timestamp,geometry\na,2024-07-01T08:00:00Z,POINT (-6.5 37.25)\n"
                      "a,2024-07-01T08:20:00Z,POINT (-6.5 37.5)\n"),
               {ErrorCode::kUnknownFrame, "bees.csv", "--crs wgs84"});
}

TEST(FormatsOfAnimals, OneOfSeveralPlacesOfABodyIsAskedFor) {
  const std::string poses =
      "frame,individual,bodypart,x,y\n0,fish0,head,100,100\n0,fish0,tail,-100,100\n";
  expect_error(record(poses), {ErrorCode::kInvalidArgument, "bees.csv",
                               "awk -F',' 'NR==1||$3==\"head\"' FILE > one.csv"});
  RecordingOptions options;
  options.frames_per_second = 25.0;
  options.pixel = StatedLength{0.001, 1.0, Unit::kMillimetre};
  EXPECT_TRUE(record("frame,individual,bodypart,x,y\n0,fish0,head,100,100\n1,fish0,head,101,100\n",
                     options));
}

TEST(FormatsOfAnimals, PlacesOfNinesStandForNone) {
  expect_error(
      record("id,time_s,lat,lon\na,0,37.0,-6.0\na,1,-9999,-9999\n"),
      {ErrorCode::kInvalidLongitude, "bees.csv:3:4", "leave such records out with --skip-bad"});
}

TEST(FormatsOfAnimals, WhatIsNotDeterminedIsNoHeader) {
  const auto recording = recording_of(record(
      "id,datetime,lat,lon\nv0,2024-07-01 08:00:00,37.0,-6.0\nv0,2024-07-01 08:10:00,n.d.,n.d.\n"
      "v0,2024-07-01 08:20:00,37.0,-6.1\n"));
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_EQ(recording.bees[0].fixes.size(), 2U);
}

TEST(FormatsOfAnimals, DaysOfMatlabAreAskedAbout) {
  const std::string days =
      "id,time,lat,lon\na,739433.333333,37.0,-6.0\na,739433.340278,37.0,-6.0\n";
  expect_error(record(days), {ErrorCode::kInvalidArgument, "bees.csv:1:2", "datestr"});
  RecordingOptions options;
  options.time_unit = Unit::kSecond;
  expect_error(record(days, options), {ErrorCode::kInvalidArgument, "bees.csv:1:2", "datestr"});
  EXPECT_TRUE(record("id,time,lat,lon\na,739433.25,37.0,-6.0\na,739433.5,37.0,-6.0\n", options));
}

TEST(FormatsOfAnimals, WhatExcelSpoiltIsSaid) {
  expect_error(record("id,time,x_mm,y_mm\na,00:00.0,1,2\n"),
               {ErrorCode::kNotANumber, "bees.csv:1:2", "Excel shows times so"});
}

TEST(FormatsOfAnimals, DifferencesOfPandasAreNamed) {
  expect_error(record("elapsed,robot,x [m],y [m]\n0 days 00:00:01.5,a,1,2\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1:1",
                "pandas.to_timedelta(df['elapsed']).dt.total_seconds()"});
}

TEST(FormatsOfAnimals, WholeNumbersWithAPointTellNoUnit) {
  expect_error(record("time,robot,x_m,y_m\n1718000000.0,r1,-6,0\n1718100000.0,r1,-5.9,0\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:1", "in which unit?"});
}

TEST(FormatsOfAnimals, SecondsWithFractionsTellTheirUnit) {
  const auto recording = recording_of(
      record(",stamp,robot,x,y,theta\n0,1718000000.000,r1,-6.0,0.0,0.0\n1,1718000000.100,r1,-5.9,"
             "0.0,0.0\n"));
  // Poses of robots are in metres, though the numbers may be degrees.
  EXPECT_EQ(recording.frame, Frame::kMetres);
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1718000000.0, 1718000000.1}));
}

}  // namespace
}  // namespace beespace::io
