// PX4 logs, made here byte by byte: definitions, units and axes, clocks, damage.
#include "io/frames/map_projection.hpp"
#include "io/px4/ulog_format.hpp"
#include "tests/io/px4/ulog_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;
using Times = std::vector<double>;

constexpr std::uint64_t kNoon_us = 1714564800'000'000;
constexpr double kNoon_s = 1714564800.0;

Result<Recording> load(std::string_view log, const RecordingOptions& options = {}) {
  return load_recording_from_memory(log, "flights/north.ulg", options);
}

RecordingOptions with_metres() {
  RecordingOptions options;
  options.frame = Frame::kMetres;
  return options;
}

// Two places and a time of GPS.
UlogMaking small_log() {
  UlogMaking log = px4_log();
  log.data(kGpsNumber, gps_message(5'000'000, kNoon_us + 5'000'000));
  log.data(kGlobalNumber, global_message({.micros = 5'000'000}));
  log.data(kGlobalNumber, global_message({.micros = 5'500'000, .lat = 47.2500001}));
  return log;
}

// For PX4's own reader: tests/cli/robotics/make-files --check.
TEST(UlogMaking, KeepsLogsWhereItIsAskedTo) {
  const char* const folder = std::getenv("BEESPACE_KEEP_LOGS");
  if (folder == nullptr) GTEST_SKIP() << "BEESPACE_KEEP_LOGS names no folder";
  UlogMaking log = small_log();
  log.data(kLocalNumber, local_message({.micros = 5'000'000, .x = 1, .y = 2, .z = -3, .vx = 4}));
  log.dropout(30).sync();
  std::ofstream(std::string(folder) + "/made.ulg", std::ios::binary) << log.bytes();
}

TEST(UlogArchive, ADroneALogBesideWhatElseWasPacked) {
  const std::string log = small_log().bytes();
  const std::string archive =
      zipped({{"south/log_2.ulg", log}, {"north/log_1.ulg", log}, {"notes.md", "x"}});
  const auto recording = recording_of(load_recording_from_memory(archive, "flight.zip", {}));
  EXPECT_EQ(ids_of(recording), (Ids{"log_1", "log_2"}));
  EXPECT_EQ(recording.missing.files, 0u);
  // Where both are called alike, their folders tell them apart.
  const auto same = recording_of(load_recording_from_memory(
      zipped({{"a/log.ulg", log}, {"b/log.ulg", log}}), "flight.zip", {}));
  ASSERT_EQ(same.bees.size(), 2u);
  EXPECT_NE(same.bees[0].id, same.bees[1].id);
}

// ---- Definitions --------------------------------------------------------------------------------

TEST(UlogFormat, FieldsFollowEachOtherThroughArraysAndNestedDefinitions) {
  UlogDefinitions definitions;
  definitions.add(
      "outer:uint64_t timestamp;inner[2] both;float[3] three;int16_t last;"
      "uint8_t[2] _padding0;");
  definitions.add("inner:int8_t a;leaf b;bool c;");
  definitions.add("leaf:double d;char[4] e;");
  const auto layout = definitions.layout("outer");
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->fields[1].offset, 8u);
  EXPECT_EQ(layout->fields[2].offset, 8u + 2 * (1 + 12 + 1));
  EXPECT_EQ(layout->number("last")->offset, 8u + 28 + 12);
  EXPECT_EQ(layout->number("three"), nullptr);  // not one number
  EXPECT_EQ(layout->number("both"), nullptr);
  EXPECT_EQ(layout->least_size, 8u + 28 + 12 + 2);
  EXPECT_EQ(layout->size, layout->least_size + 2);
}

TEST(UlogFormat, NumbersOfAllTypes) {
  UlogDefinitions definitions;
  definitions.add(
      "all:int8_t a;uint8_t b;int16_t c;uint16_t d;int32_t e;uint32_t f;int64_t g;"
      "uint64_t h;float i;double j;bool k;char l;");
  const auto layout = definitions.layout("all");
  ASSERT_TRUE(layout);
  UlogBody body;
  body.u8(0xFF).u8(0xFF).u16(0xFFFE).u16(0xFFFE).u32(0xFFFFFFFD).u32(0xFFFFFFFD);
  body.u64(0xFFFFFFFFFFFFFFFC).u64(4'000'000'000'000).f32(-1.5).f64(2.25).u8(1).u8('x');
  ASSERT_EQ(body.bytes().size(), layout->size);
  const std::vector<double> expected = {-1, 255,  -2,   65534, -3, 4294967293.0,
                                        -4, 4e12, -1.5, 2.25,  1,  120};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(ulog_number(body.bytes(), layout->fields[i]), expected[i]) << i;
  }
  EXPECT_EQ(ulog_unsigned(body.bytes(), layout->fields[7]), 4'000'000'000'000u);
  EXPECT_FALSE(ulog_unsigned(body.bytes(), layout->fields[8]));
}

TEST(UlogFormat, WhatCannotBeReadIsNoLayout) {
  UlogDefinitions definitions;
  definitions.add("self:uint8_t a;self b;");
  definitions.add("ping:pong a;");
  definitions.add("pong:ping a;");
  definitions.add("missing:nowhere a;");
  definitions.add("large:uint8_t[65535] a;uint8_t b;");
  definitions.add("none:uint8_t[0] a;");
  definitions.add("open:uint8_t[3 a;");
  definitions.add("nameless:uint8_t;");
  definitions.add("no colon");
  // Each has the one before it a hundred times: 10^10 fields, and no byte.
  definitions.add("bomb0:bomb1 a;");
  std::string wide = ":";
  for (int i = 0; i < 100; ++i) wide += "empty a;";
  definitions.add("empty:");
  std::string of_last = "empty";
  for (const char* const name : {"w1", "w2", "w3", "w4", "w5"}) {
    std::string fields;
    for (int i = 0; i < 100; ++i) fields += of_last + " a;";
    definitions.add(std::string(name) + ":" + fields);
    of_last = name;
  }
  for (const char* const name : {"self", "ping", "missing", "large", "none", "open", "nameless",
                                 "no colon", "bomb0", "w5", ""}) {
    EXPECT_FALSE(definitions.layout(name)) << name;
  }
  EXPECT_TRUE(definitions.layout("w1"));
}

// ---- Positions ----------------------------------------------------------------------------------

TEST(Ulog, GlobalPositionsAreDegreesAndMetresAboveMeanSeaLevel) {
  const auto recording = recording_of(load(small_log().bytes()));
  ASSERT_EQ(ids_of(recording), Ids{"north"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(times_of(bee), (Times{kNoon_s + 5, kNoon_s + 5.5}));
  EXPECT_EQ(bee.fixes[0].position, (Point{8.5, 47.25, 512}));
  EXPECT_EQ(bee.fixes[1].position, (Point{8.5, 47.2500001, 512}));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.heights, HeightDatum::kMeanSeaLevel);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(recording.format_description, "PX4 log (ULog)");
  EXPECT_TRUE(has_note(recording, "vehicle_global_position, heights above mean sea level"));
  EXPECT_EQ(recording.missing.count, 0u);
}

TEST(Ulog, HeightsAboveTheEllipsoidAreTakenForAllWhereAsked) {
  RecordingOptions options;
  options.heights = HeightSource::kGeometric;
  UlogMaking log = small_log();
  log.data(kGlobalNumber, global_message({.micros = 6'000'000, .alt_ellipsoid = NAN}));
  const auto recording = recording_of(load(log.bytes(), options));
  EXPECT_EQ(recording.heights, HeightDatum::kEllipsoid);
  ASSERT_EQ(recording.bees[0].fixes.size(), 2u);
  EXPECT_EQ(recording.bees[0].fixes[0].position.z, 560);
  EXPECT_TRUE(has_note(recording, "1 record without a height above the ellipsoid is left out"));
  EXPECT_EQ(recording.missing.count, 1u);
  options.heights = HeightSource::kPressure;
  expect_error(load(log.bytes(), options),
               {ErrorCode::kInvalidArgument, "flights/north.ulg", "none by pressure"});
}

// Nothing smaller than what motion is computed with comes out of a reader: computed degrees that
// should be 0 are often a little beside it.
TEST(Ulog, DegreesTooSmallToBeAnythingAreZero) {
  UlogMaking log = px4_log();
  log.data(kGlobalNumber, global_message({.micros = 5'000'000, .lat = 1e-40, .lon = 0.001}));
  log.data(kGlobalNumber, global_message({.micros = 6'000'000, .lat = 0.001, .lon = -4e-310}));
  const auto recording = load(log.bytes());
  ASSERT_TRUE(recording) << recording.error().message;
  const auto& fixes = recording.value().bees.at(0).fixes;
  EXPECT_EQ(fixes.at(0).position.y, 0.0);
  EXPECT_EQ(fixes.at(1).position.x, 0.0);
}

TEST(Ulog, VelocitiesAreThoseOfTheLocalPositionOfTheSameMeasurement) {
  UlogMaking log = px4_log();
  log.data(kGpsNumber, gps_message(1, kNoon_us + 1));
  log.data(kLocalNumber,
           local_message({.micros = 1'000'900, .vx = 4, .vy = 5, .vz = -6, .sample = 1'000'000}));
  log.data(kGlobalNumber, global_message({.micros = 1'000'950, .sample = 1'000'000}));
  log.data(kGlobalNumber, global_message({.micros = 1'200'950, .sample = 1'200'000}));
  const auto recording = recording_of(load(log.bytes()));
  ASSERT_EQ(recording.bees[0].velocities.size(), 2u);
  EXPECT_EQ(recording.bees[0].velocities[0], (Velocity{5, 4, 6}));
  EXPECT_TRUE(std::isnan(recording.bees[0].velocities[1].x));
}

TEST(Ulog, LogsOfOldHaveWholeDegreesAndTheirOwnVelocities) {
  UlogMaking log(0);
  log.format(
      "vehicle_global_position:uint64_t timestamp;int32_t lat;int32_t lon;float alt;"
      "float vel_n;float vel_e;float vel_d;");
  log.subscribe(1, "vehicle_global_position");
  UlogBody body;
  body.u64(2'000'000).i32(-338'500'001).i32(-705'000'000).f32(90.5).f32(1).f32(2).f32(3);
  log.data(1, body);
  const auto recording = recording_of(load(log.bytes()));
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.fixes[0].position, (Point{-70.5, -33.8500001, 90.5}));
  EXPECT_EQ(bee.velocities[0], (Velocity{2, 1, -3}));
  EXPECT_EQ(times_of(bee), Times{2});
  EXPECT_FALSE(recording.since_1970);
  EXPECT_TRUE(has_note(recording, "seconds since the drone was switched on"));
}

TEST(Ulog, LocalPositionsAreBroughtToDegreesFromTheirReference) {
  UlogMaking log = px4_log();
  log.data(kGpsNumber, gps_message(1, kNoon_us + 1));
  log.data(kLocalNumber, local_message({.micros = 500'000, .global = false}));
  log.data(kLocalNumber,
           local_message(
               {.micros = 1'000'000, .x = 300, .y = 400, .z = -20, .vx = 1, .vy = 2, .vz = 3}));
  const auto recording = recording_of(load(log.bytes()));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.heights, HeightDatum::kMeanSeaLevel);
  ASSERT_EQ(recording.bees[0].fixes.size(), 1u);
  const Point& at = recording.bees[0].fixes[0].position;
  // On a sphere of 6,371 km, to first order: a degree of latitude is 111,194.93 m.
  EXPECT_NEAR(at.y, 47.25 + 300 / 111'194.9266, 2e-7);
  EXPECT_NEAR(at.x, 8.5 + 400 / (111'194.9266 * std::cos(47.25 * M_PI / 180)), 4e-7);
  EXPECT_EQ(at.z, 520);
  EXPECT_EQ(recording.bees[0].velocities[0], (Velocity{2, 1, -3}));
  EXPECT_TRUE(has_note(recording, "as PX4 does"));
  EXPECT_TRUE(has_note(recording, "1 record of local positions whose place on the Earth is not"));
}

TEST(Ulog, TheReferenceIsReachedFromAllSides) {
  // There and back: the distance and the direction on the sphere are those that were put in.
  const LongitudeLatitude reference{179.9999, -60.0};
  for (const auto& [north, east] : {std::pair{1e4, 0.0}, {-1e4, 0.0}, {0.0, 2e4}, {3e3, -4e3}}) {
    const LongitudeLatitude there = px4_reprojected(reference, north, east);
    const double degree = M_PI / 180;
    const double lat0 = reference.latitude_deg * degree;
    const double lat1 = there.latitude_deg * degree;
    const double turn = (there.longitude_deg - reference.longitude_deg) * degree;
    const double away = std::acos(std::sin(lat0) * std::sin(lat1) +
                                  std::cos(lat0) * std::cos(lat1) * std::cos(turn));
    const double bearing = std::atan2(
        std::sin(turn) * std::cos(lat1),
        std::cos(lat0) * std::sin(lat1) - std::sin(lat0) * std::cos(lat1) * std::cos(turn));
    EXPECT_NEAR(away * 6371000, std::hypot(north, east), 1e-2);
    EXPECT_NEAR(std::remainder(bearing - std::atan2(east, north), 2 * M_PI), 0, 1e-6);
    EXPECT_LE(std::abs(there.longitude_deg), 180);
  }
}

TEST(Ulog, LocalPositionsWithoutAReferenceAreMetresEastNorthUp) {
  UlogMaking log = px4_log();
  log.data(kLocalNumber, local_message({.micros = 1'000'000,
                                        .x = 1.5,
                                        .y = 2.5,
                                        .z = -10,
                                        .vx = 4,
                                        .vy = 5,
                                        .vz = -6,
                                        .global = false}));
  log.data(kLocalNumber, local_message({.micros = 2'000'000, .v_valid = false, .global = false}));
  log.data(kLocalNumber, local_message({.micros = 3'000'000, .valid = false, .global = false}));
  log.data(kLocalNumber, local_message({.micros = 4'000'000, .z_valid = false, .global = false}));
  const auto recording = recording_of(load(log.bytes()));
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_EQ(recording.heights, HeightDatum::kHome);
  EXPECT_EQ(times_of(bee), (Times{1, 2}));
  EXPECT_EQ(bee.fixes[0].position, (Point{2.5, 1.5, 10}));
  EXPECT_EQ(bee.velocities[0], (Velocity{5, 4, 6}));
  EXPECT_TRUE(std::isnan(bee.velocities[1].x));
  EXPECT_TRUE(has_note(recording,
                       "1 record in which a drone says itself that it does not know its "
                       "place is left out"));
  EXPECT_TRUE(has_note(recording, "does not know its height is left out"));
  EXPECT_EQ(recording.missing.count, 2u);
}

TEST(Ulog, MetresThatAreAskedForAreLocalOnes) {
  UlogMaking log = small_log();
  expect_error(load(log.bytes(), with_metres()),
               {ErrorCode::kNoPoints, "flights/north.ulg", "leave --crs out"});
  log.data(kLocalNumber, local_message({.micros = 5'000'000, .x = 7}));
  const auto recording = recording_of(load(log.bytes(), with_metres()));
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_EQ(recording.bees[0].fixes[0].position, (Point{0, 7, 0}));
  EXPECT_EQ(recording.bees[0].fixes.size(), 1u);
}

TEST(Ulog, FlagsOfNewerLogsAreObeyed) {
  UlogMaking log;
  log.format(
      "vehicle_global_position:uint64_t timestamp;double lat;double lon;float alt;"
      "bool lat_lon_valid;bool alt_valid;uint8_t[2] _padding0;");
  log.subscribe(1, "vehicle_global_position");
  for (const auto& [place, height] : {std::pair{1u, 1u}, {0u, 1u}, {1u, 0u}}) {
    const std::uint64_t micros = 1'000'000 + 100u * (2 * place + height);
    log.data(1, UlogBody().u64(micros).f64(47).f64(8).f32(9).u8(place).u8(height));
  }
  const auto recording = recording_of(load(log.bytes()));
  EXPECT_EQ(times_of(recording.bees[0]), Times{1.0003});
  EXPECT_EQ(recording.missing.count, 2u);
}

TEST(Ulog, AnotherInstanceOfATopicIsLeftOutAndSaid) {
  UlogMaking log = small_log();
  log.subscribe(40, "vehicle_global_position", 1);
  log.data(40, global_message({.micros = 5'100'000, .lat = 10}));
  const auto recording = recording_of(load(log.bytes()));
  EXPECT_EQ(recording.bees[0].fixes.size(), 2u);
  EXPECT_TRUE(has_note(recording, "vehicle_global_position 1 is another instance"));
}

// ---- Clocks -------------------------------------------------------------------------------------

TEST(Ulog, PlacesThatAreNoNumbersAreNotKnown) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  UlogMaking log = px4_log();
  log.data(kGlobalNumber, global_message({.micros = 1'000'000, .lat = kNan}));
  log.data(kGlobalNumber, global_message({.micros = 2'000'000}));
  const auto recording = recording_of(load(log.bytes()));
  EXPECT_EQ(recording.bees[0].fixes.size(), 1u);
  EXPECT_TRUE(has_note(recording, "1 record in which a drone says itself that it does not know"));
  EXPECT_EQ(recording.missing.count, 1u);
}

TEST(Ulog, TheClockIsTheMedianOfGps) {
  UlogMaking log = px4_log();
  log.data(kGpsNumber, gps_message(1'000'000, 0));                    // does not know the time yet
  log.data(kGpsNumber, gps_message(1'100'000, 990'000'000'000'000));  // nor really
  log.data(kGpsNumber, gps_message(2'000'000, kNoon_us + 2'000'000 + 18'000'000));  // leap seconds
  // Each says the time of an instant 60 ms before it came; a few are later.
  for (std::uint64_t i = 3; i < 60; ++i) {
    const std::uint64_t late = i % 10 == 0 ? 30'000 : 0;
    log.data(kGpsNumber,
             gps_message(i * 1'000'000 + late, kNoon_us + i * 1'000'000 - 60'000, -60'000));
  }
  log.data(kGlobalNumber, global_message({.micros = 4'000'000}));
  const auto recording = recording_of(load(log.bytes()));
  EXPECT_EQ(times_of(recording.bees[0]), Times{kNoon_s + 4});
  EXPECT_TRUE(has_note(recording, "58 times of GPS, nine of ten of which agree within 30 ms"));
}

class SeveralLogs : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& content) {
    return folder_.write(name, content);
  }

  TemporaryFolder folder_;
};

TEST_F(SeveralLogs, AreDronesOnOneClock) {
  UlogMaking other = px4_log();  // switched on 100 s later
  other.data(kGpsNumber, gps_message(1'000'000, kNoon_us + 101'000'000));
  other.data(kGlobalNumber, global_message({.micros = 2'000'000, .lat = 47.3}));
  const auto recording = recording_of(
      load_recording({write("a.ulg", small_log().bytes()), write("b.ulg", other.bytes())}, {}));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "b"}));
  EXPECT_EQ(times_of(recording.bees[0]), (Times{kNoon_s + 5, kNoon_s + 5.5}));
  EXPECT_EQ(times_of(recording.bees[1]), Times{kNoon_s + 102});
}

TEST_F(SeveralLogs, OfAFolderAreReadByTheirNames) {
  write("b.ulg", small_log().bytes());
  write("a.ulg", small_log().bytes());
  write("notes.md", "nothing");
  const auto recording = recording_of(load_recording({folder_.file("")}, {}));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "b"}));
}

TEST_F(SeveralLogs, BesideTablesInAFolderAreSaidToBeLeftOut) {
  write("b.ulg", small_log().bytes());
  write("c.ulg", small_log().bytes());
  EXPECT_FALSE(has_note(recording_of(load_recording({folder_.file("")}, {})), "left out"));
  write("a.csv", "id,time_s,x_m,y_m,z_m\nd,0,1,2,3\n");
  const auto recording = recording_of(load_recording({folder_.file("")}, {}));
  EXPECT_EQ(ids_of(recording), Ids{"d"});
  EXPECT_TRUE(has_note(recording, "b.ulg and 1 more are left out; name them, too"));
}

// What is said of units is said of the table.
TEST_F(SeveralLogs, BesideATableOfWhichTheUnitsAreSaid) {
  const std::string log = write("a.ulg", small_log().bytes());
  const std::string table = write("b.csv", "id,timestamp,lat,lon,alt\nd,1795000000,47,8,5000\n");
  RecordingOptions options;
  options.time_unit = Unit::kSecond;
  options.units.height = Unit::kMillimetre;
  EXPECT_FALSE(load_recording({log}, options));
  const auto recording = recording_of(load_recording({log, table}, options));
  ASSERT_EQ(recording.bees.size(), 2u);
  EXPECT_EQ(recording.bees[1].fixes[0].position.z, 5.0);
}

TEST_F(SeveralLogs, OptionsThatNoneOfSeveralLogsIsReadByAreRefused) {
  const std::string a = write("a.ulg", small_log().bytes());
  const std::string b = write("b.ulg", small_log().bytes());
  RecordingOptions options;
  options.time_unit = Unit::kSecond;
  expect_error(load_recording({a, b}, options),
               {ErrorCode::kInvalidArgument, a,
                "the times of a PX4 log have their unit; leave --time-unit out"});
  options = {};
  options.units.height = Unit::kFoot;
  expect_error(load_recording({a, b}, options),
               {ErrorCode::kInvalidArgument, a, "leave --units out"});
}

TEST_F(SeveralLogs, WithoutATimeOfGpsShareNoClock) {
  UlogMaking other = px4_log();
  other.data(kGlobalNumber, global_message({.micros = 2'000'000}));
  const std::string with = write("a.ulg", small_log().bytes());
  const std::string without = write("b.ulg", other.bytes());
  expect_error(load_recording({with, without}, {}),
               {ErrorCode::kInvalidArgument, without, "it shares no clock with other inputs"});
  expect_error(load_recording({without, without}, {}),
               {ErrorCode::kInvalidArgument, without, "it shares no clock with other inputs"});
  EXPECT_TRUE(load_recording({without}, {}));
}

TEST_F(SeveralLogs, WhoseClocksContradictGpsAreRefused) {
  UlogMaking other = px4_log();
  for (std::uint64_t i = 1; i < 40; ++i) {
    other.data(kGpsNumber, gps_message(i * 1'000'000, kNoon_us + i * 1'100'000));
  }
  other.data(kGlobalNumber, global_message({.micros = 2'000'000}));
  const std::string path = write("b.ulg", other.bytes());
  expect_error(load_recording({write("a.ulg", small_log().bytes()), path}, {}),
               {ErrorCode::kInvalidArgument, path, "contradict its own clock by 3600 ms"});
}

TEST_F(SeveralLogs, WhoseClocksMayDifferAreNoAllClear) {
  const std::string path = write("a.ulg", small_log().bytes());
  for (const std::uint64_t late_us : {90'000u, 400'000u}) {
    UlogMaking other = px4_log();
    for (std::uint64_t i = 1; i < 40; ++i) {
      const std::uint64_t late = i % 2 == 0 ? late_us : 0;
      other.data(kGpsNumber, gps_message(i * 1'000'000 + late, kNoon_us + i * 1'000'000));
    }
    other.data(kGlobalNumber, global_message({.micros = 2'000'000}));
    const std::string second = write("b.ulg", other.bytes());
    const bool doubtful = late_us > 100'000;
    const auto together = recording_of(load_recording({path, second}, {}));
    EXPECT_EQ(together.missing.untimed, doubtful ? 1u : 0u);
    EXPECT_EQ(has_note(together, "off from the clocks of other inputs: " + second), doubtful);
    EXPECT_TRUE(recording_of(load_recording({second}, {})).missing.none());
  }
}

TEST_F(SeveralLogs, InMetresOfTheirOwnAreComparedOnlyWhereThatIsSaid) {
  UlogMaking log = px4_log();
  log.data(kGpsNumber, gps_message(1, kNoon_us + 1));
  log.data(kLocalNumber, local_message({.micros = 1'000'000, .global = false}));
  const std::string a = write("a.ulg", log.bytes());
  const std::string b = write("b.ulg", log.bytes());
  expect_error(load_recording({a, b}, {}), {ErrorCode::kUnknownFrame, a,
                                            "say --crs metres if all drones have the same origin"});
  EXPECT_EQ(ids_of(recording_of(load_recording({a, b}, with_metres()))), (Ids{"a", "b"}));
}

TEST_F(SeveralLogs, WithHeightsOfTwoKindsAreNotMixed) {
  const std::string table =
      write("t.csv", "id,unix_time_s,lon,lat,height_ellipsoid_m\nc,5,8,47,3\n");
  const auto loaded = load_recording({write("a.ulg", small_log().bytes()), table}, {});
  expect_error(loaded, {ErrorCode::kInvalidArgument, table, "above mean sea level"});
}

// ---- Damage -------------------------------------------------------------------------------------

TEST(Ulog, DropoutsAreCountedAndSaid) {
  UlogMaking log = small_log();
  log.dropout(30).dropout(12);
  const auto recording = recording_of(load(log.bytes()));
  EXPECT_TRUE(has_note(recording, "the drone could not write all: 2 dropouts, 42 ms in all"));
}

TEST(Ulog, DamageIsPassedOverAndCounted) {
  for (const bool marked : {false, true}) {
    UlogMaking log = small_log();
    const std::size_t at = log.bytes().size();
    log.raw(std::string("\xFF\xFFnothing that is a message", 27));
    if (marked) log.sync();
    log.data(kGlobalNumber, global_message({.micros = 6'000'000}));
    const auto recording = recording_of(load(log.bytes()));
    EXPECT_EQ(recording.bees[0].fixes.size(), 3u);
    EXPECT_TRUE(has_note(recording, "27 bytes in 1 place are no message of a log"));
    EXPECT_TRUE(has_note(recording, "the first at byte " + std::to_string(at)));
    EXPECT_EQ(recording.missing.count, 1u);
  }
}

TEST(Ulog, AMessageOfAnotherLengthThanItsDefinitionSaysIsDamage) {
  const std::string whole = global_message({.micros = 6'000'000}).bytes();
  for (const std::size_t length : {whole.size() - 1, whole.size() + 5}) {
    UlogMaking log = small_log();
    log.data(kGlobalNumber, UlogBody().text((whole + "12345").substr(0, length)));
    log.data(kGlobalNumber, global_message({.micros = 7'000'000}));
    const auto recording = recording_of(load(log.bytes()));
    EXPECT_EQ(recording.bees[0].fixes.size(), 3u) << length;
    EXPECT_TRUE(has_note(recording, "in 1 place")) << length;
  }
  UlogMaking padded = small_log();  // with the padding at its end, as other writers have it
  padded.data(kGlobalNumber, UlogBody().text(whole + std::string(4, '\0')));
  EXPECT_EQ(recording_of(load(padded.bytes())).bees[0].fixes.size(), 3u);
}

TEST(Ulog, ALogThatIsCutShortIsReadAsFarAsItGoes) {
  const std::string whole = small_log().bytes();
  const std::string next =
      small_log().data(kGlobalNumber, global_message({.micros = 6'000'000})).bytes();
  for (std::size_t length = whole.size() + 1; length < next.size(); ++length) {
    const auto recording = recording_of(load(next.substr(0, length)));
    EXPECT_EQ(recording.bees[0].fixes.size(), 2u) << length;
    EXPECT_TRUE(
        has_note(recording, "ends within a message, at byte " + std::to_string(whole.size())))
        << length;
    EXPECT_EQ(recording.missing.count, 1u) << length;
  }
}

TEST(Ulog, ALogThatEndsBeforeItsDataSaysWhere) {
  const std::string whole = small_log().bytes();
  for (std::size_t length = 7; length < px4_log().bytes().size(); ++length) {
    const auto loaded = load(whole.substr(0, length));
    ASSERT_FALSE(loaded) << length;
    const Error& error = loaded.error();
    EXPECT_TRUE(error.code == ErrorCode::kTruncated || error.code == ErrorCode::kNoPoints)
        << length;
    EXPECT_NE(error.message.find("PX4 log"), std::string::npos) << error.message;
  }
  expect_error(load(whole.substr(0, 12)),
               {ErrorCode::kTruncated, "flights/north.ulg", "at byte 12"});
}

TEST(Ulog, AnyByteThatIsChangedIsNoCrash) {
  const std::string whole = small_log().dropout(3).sync().bytes();
  for (std::size_t at = 7; at < whole.size(); ++at) {
    for (const int bit : {1, 128}) {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ bit);
      const auto loaded = load(changed);
      if (!loaded) {
        EXPECT_FALSE(loaded.error().message.empty()) << at;
      }
    }
  }
}

TEST(Ulog, DefinitionsThatAreDamagedAreAnErrorOfTheirTopic) {
  UlogMaking log;
  log.format("vehicle_global_position:uint64_t timestamp;double lat;double lon;float[ alt;");
  log.subscribe(1, "vehicle_global_position");
  log.data(1, UlogBody().u64(1).f64(47).f64(8).f32(9));
  expect_error(load(log.bytes()), {ErrorCode::kCorrupt, "flights/north.ulg",
                                   "has vehicle_global_position, but its definition"});
}

TEST(Ulog, DataAppendedLaterIsReadBehindAMessageThatWasCut) {
  // What the flags say first is where the log ends; its last message is cut there.
  const auto made = [](std::uint64_t appended_at) {
    UlogMaking log;
    log.flags(appended_at == 0 ? 0 : 1, appended_at);
    log.format(kGlobalFormat).subscribe(kGlobalNumber, "vehicle_global_position");
    log.data(kGlobalNumber, global_message({.micros = 1'000'000}));
    const std::string cut =
        ulog_message('D', UlogBody().u16(kGlobalNumber).text(global_message({}).bytes()).bytes());
    return log.raw(cut.substr(0, 20));
  };
  UlogMaking log = made(made(0).bytes().size());
  log.data(kGlobalNumber, global_message({.micros = 2'000'000}));
  const auto recording = recording_of(load(log.bytes()));
  EXPECT_EQ(times_of(recording.bees[0]), (Times{1, 2}));
  EXPECT_FALSE(has_note(recording, "damaged"));
}

TEST(Ulog, FeaturesThatAreNotKnownAreRefused) {
  UlogMaking log;
  log.flags(2);
  expect_error(load(log.bytes()), {ErrorCode::kUnsupportedFormat, "flights/north.ulg",
                                   "at byte 27 that it cannot be read without a feature"});
  UlogMaking newer(2);
  expect_error(load(newer.bytes()),
               {ErrorCode::kUnsupportedFormat, "flights/north.ulg", "version 2 of ULog"});
}

TEST(Ulog, OptionsOfTablesAreRefused) {
  RecordingOptions options;
  options.columns = "time=1,x=2,y=3";
  expect_error(load(small_log().bytes(), options),
               {ErrorCode::kInvalidArgument, "flights/north.ulg", "--columns is for tables"});
}

TEST(Ulog, ALogWithoutPositionsSaysWhatItHas) {
  UlogMaking log = px4_log();
  log.data(99, UlogBody().f32(12).u8(4));
  expect_error(load(log.bytes()), {ErrorCode::kNoPoints, "flights/north.ulg",
                                   "0 messages of vehicle_global_position and 0 of"});
  log.data(kLocalNumber, local_message({.micros = 1, .valid = false}));
  expect_error(load(log.bytes()),
               {ErrorCode::kNoPoints, "flights/north.ulg", "none of which can be taken"});
}

}  // namespace
}  // namespace beespace::io
