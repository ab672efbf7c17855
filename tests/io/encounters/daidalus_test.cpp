// DAIDALUS encounters: geodetic and Euclidean columns, their units, and what is broken.
#include "tests/io/tracks/recording_loading.hpp"

#include <cmath>
#include <string>

namespace beespace::io {
namespace {

constexpr std::string_view kGeodetic =
    "## DAAGenerator -forward 20\n"
    "NAME lat lon alt trk gs vs heading airspeed time alerter sz_std\n"
    "[none] [deg] [deg] [ft] [deg] [knot] [fpm] [deg] [knot] [s] [none] [ft]\n"
    "Ownship, 40.7, -74.0, 15000.0, 90.0, 120.0, 600.0, 5.0, 80.9, 0.0, 1, 0.0\n"
    "Intruder, 40.8, -73.9, 16000.0, 270.0, 180.0, 0.0, 270.0, 180.0, 0.0, 1, 0.0\n"
    "# a second later\n"
    "Ownship, 40.7, -73.9993, 15010.0, 90.0, 120.0, 600.0, 5.0, 80.9, 1.0, 1, 0.0\n"
    "Intruder, 40.8, -73.9011, 16000.0, 270.0, 180.0, 0.0, 270.0, 180.0, 1.0, 1, 0.0\n";

TEST(Daidalus, GeodeticEncountersAreRecordings) {
  const Recording recording = recording_of(record(kGeodetic));
  ASSERT_EQ(ids_of(recording), (std::vector<std::string>{"Ownship", "Intruder"}));
  EXPECT_EQ(recording.format_description, "DAIDALUS encounter");
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.height_unit, Unit::kFoot);
  const RecordedBee& own = recording.bees[0];
  EXPECT_EQ(own.fixes.at(0), (Fix{0.0, {-74.0, 40.7, 4572.0}}));
  EXPECT_EQ(times_of(own), (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(own.stated_heights.at(1), 15010.0);
  // Over ground, not through the air.
  EXPECT_NEAR(own.velocities.at(0).x, 120.0 * 1852 / 3600, 1e-9);
  EXPECT_NEAR(own.velocities.at(0).y, 0.0, 1e-9);
  EXPECT_NEAR(own.velocities.at(0).z, 600 * 0.3048 / 60, 1e-12);
  EXPECT_TRUE(has_note(recording, "the first aircraft of each time is the ownship"));
  EXPECT_EQ(recording.units.at(0).reason, "the line of units says so");
}

TEST(Daidalus, VelocitiesMayBeAlongAxes) {
  const Recording recording = recording_of(
      record("NAME,     lat,    lon,    alt,    vx,     vy,     vz,     time \n"
             " unitless,   [deg],    [deg],   [ft],    [knot],   [m/s],  [fpm],  [s] \n"
             "Ownship, 33.8, -117.0, 17000.0, 36, 200.0, -60, 0.0\n"));
  const Velocity velocity = recording.bees.at(0).velocities.at(0);
  EXPECT_NEAR(velocity.x, 36 * 1852 / 3600.0, 1e-12);
  EXPECT_EQ(velocity.y, 200.0);
  EXPECT_NEAR(velocity.z, -0.3048, 1e-12);
}

TEST(Daidalus, EuclideanEncountersAreMetresEastAndNorth) {
  const std::string rows = "ownship 0 0 5000 200 100 -500 0\nintruder 3.5 -1 5500 10 20 0 0\n";
  const Recording axes = recording_of(record(
      "NAME sx sy sz vx vy vz time\n[none] [nmi] [nmi] [ft] [knot] [knot] [fpm] [s]\n" + rows));
  ASSERT_EQ(ids_of(axes), (std::vector<std::string>{"ownship", "intruder"}));
  EXPECT_EQ(axes.frame, Frame::kMetres);
  EXPECT_EQ(axes.bees[1].fixes.at(0).position, (Point{6482.0, -1852.0, 1676.4}));
  EXPECT_EQ(axes.bees[1].stated_heights.at(0), 5500.0);
  EXPECT_NEAR(axes.bees[0].velocities.at(0).x, 200 * 1852 / 3600.0, 1e-12);
  EXPECT_NEAR(axes.bees[0].velocities.at(0).z, -2.54, 1e-12);
  EXPECT_TRUE(has_note(axes, "sx counts to the east, sy to the north, sz upwards"));
  // 200 knots on a track of 90 degrees are to the east.
  const Recording track = recording_of(
      record("NAME sx sy sz trk gs vs time\n[none] [m] [km] [m] [deg] [knot] [fpm] [s]\n"
             "ownship 1 2 3 90 200 0 0\n"));
  EXPECT_EQ(track.bees.at(0).fixes.at(0).position, (Point{1.0, 2000.0, 3.0}));
  EXPECT_NEAR(track.bees[0].velocities.at(0).x, 200 * 1852 / 3600.0, 1e-9);
  EXPECT_NEAR(track.bees[0].velocities.at(0).y, 0.0, 1e-9);
}

void expect_bad(std::string_view text, ErrorCode code, std::string_view part) {
  const auto loaded = record(text);
  ASSERT_FALSE(loaded.has_value()) << text;
  EXPECT_EQ(loaded.error().code, code) << to_string(loaded.error());
  EXPECT_NE(to_string(loaded.error()).find(part), std::string::npos) << to_string(loaded.error());
}

TEST(Daidalus, WhatIsBrokenSaysWhere) {
  const std::string front =
      "NAME lat lon alt trk gs vs time\n[none] [deg] [deg] [ft] [deg] [knot] [fpm] [s]\n";
  expect_bad(front + "a 1 2 3 4 5 6 7\nb 1 x 3 4 5 6 7\n", ErrorCode::kNotANumber,
             "bees.csv:4:3: 'x' is not a number (longitude)");
  expect_bad(front + "a 1 2 3 4 5 6 7\nb 1 2 3\n", ErrorCode::kColumnCount, "bees.csv:4");
  expect_bad(front, ErrorCode::kNoPoints, "no record");
  expect_bad(
      "NAME lat lon alt trk gs vs time\n[none] [rad] [deg] [ft] [deg] [knot] [fpm] [s]\n"
      "a 1 2 3 4 5 6 7\n",
      ErrorCode::kUnsupportedFormat,
      "bees.csv:2:2: column 'lat' is in '[rad]', where [deg] should be");
  expect_bad(
      "NAME lat lon alt trk gs vs time\n[none] [deg] [deg] [none] [deg] [knot] [fpm] [s]\n"
      "a 1 2 3 4 5 6 7\n",
      ErrorCode::kUnsupportedFormat, "bees.csv:2:4: column 'alt' is in '[none]', where one of");
  expect_bad("lat lon alt time\n[deg] [deg] [ft] [s]\n1 2 3 4\n", ErrorCode::kMissingColumn,
             "there is no column NAME");
  RecordingOptions options;
  options.units.height = Unit::kMetre;
  const auto asked = record(kGeodetic, options);
  ASSERT_FALSE(asked.has_value());
  EXPECT_NE(to_string(asked.error()).find("leave --units out"), std::string::npos);
}

TEST(Daidalus, TablesWithUnitsInTheirNamesAreTables) {
  const Recording table =
      recording_of(record("id,time_s,lat,lon,alt_ft\na,0,47,8,1\nb,0,47,8,2\n"));
  EXPECT_EQ(table.format_description, "text, comma-separated");
}

}  // namespace
}  // namespace beespace::io
