// PX4 logs, made here byte by byte: units and axes, heights, flags, clocks.
#include "io/frames/map_projection.hpp"
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

Result<Recording> load(std::string_view log, const RecordingOptions& options = {}) {
  return load_recording_from_memory(log, "flights/north.ulg", options);
}

RecordingOptions with_metres() {
  RecordingOptions options;
  options.frame = Frame::kMetres;
  return options;
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
