// Several PX4 logs: drones on one clock, or on none that they share.
#include "tests/io/px4/ulog_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;
using Times = std::vector<double>;

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

// As logs of one simulator, or of one time base, may have it: then it is for the caller to say.
TEST_F(SeveralLogs, WithoutATimeOfGpsHaveOneClockWhereThatIsSaid) {
  UlogMaking other = px4_log();
  other.data(kGlobalNumber, global_message({.micros = 2'000'000}));
  const std::string first = write("a.ulg", other.bytes());
  const std::string second = write("b.ulg", other.bytes());
  RecordingOptions options;
  options.one_clock = true;
  const auto recording = recording_of(load_recording({first, second}, options));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "b"}));
  EXPECT_EQ(times_of(recording.bees[1]), Times{2});
  const std::string since_1970 = write("c.ulg", small_log().bytes());
  EXPECT_FALSE(load_recording({first, since_1970}, options));
  expect_error(
      load_recording({first, second}, {}),
      {ErrorCode::kInvalidArgument, first,
       "say so with --one-clock; else read it alone, leave it out, or, if you know how far "
       "the clocks are apart, make tables with a common time: ulog2csv -m "
       "vehicle_global_position FILE"});
}

// sensor_msgs/NavSatFix has its altitude above the ellipsoid, whatever the header calls it.
TEST_F(SeveralLogs, HaveOtherHeightsThanSatelliteFixesOfRos) {
  const std::string log = write("a.ulg", small_log().bytes());
  const std::string echoed =
      write("b.csv", "1795000000,0,gps,0,1,47,8,535.0,1,0,0,0,1,0,0,0,1,2\n");
  const std::string named = write("c.csv",
                                  "%time,field.header.stamp,field.status.status,field.latitude,"
                                  "field.longitude,field.altitude,field.position_covariance_type\n"
                                  "1795000000000000000,1795000000000000000,0,47,8,535.0,2\n");
  const std::string of_bag =
      write("d.csv", "id,time_ns,lon,lat,height_ellipsoid_m\nr,1795000000000000000,8,47,535\n");
  for (const std::string& table : {echoed, named, of_bag}) {
    expect_error(load_recording({log, table}, {}),
                 {ErrorCode::kInvalidArgument, table,
                  "heights here are above the WGS84 ellipsoid, but elsewhere, as in " + log +
                      ", above mean sea level; read them apart"});
    EXPECT_TRUE(load_recording({table}, {}));
  }
}

// What a receiver says is logged before it is blended, and perhaps alone.
TEST_F(SeveralLogs, HaveTheTimeOfAReceiverWhereThatIsAllTheyHave) {
  constexpr unsigned kReceiver = 13;
  UlogMaking other = px4_log();
  other.format(
      "sensor_gps:uint64_t timestamp;uint64_t time_utc_usec;int32_t lat;int32_t lon;"
      "int32_t alt;int32_t timestamp_time_relative;uint8_t fix_type;uint8_t[7] _padding0;");
  other.subscribe(kReceiver, "sensor_gps");
  other.data(kReceiver, gps_message(1'000'000, kNoon_us + 101'000'000));
  other.data(kGlobalNumber, global_message({.micros = 2'000'000, .lat = 47.3}));
  const auto recording = recording_of(
      load_recording({write("a.ulg", small_log().bytes()), write("b.ulg", other.bytes())}, {}));
  EXPECT_EQ(times_of(recording.bees[1]), Times{kNoon_s + 102});
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
  RecordingOptions in_metres;
  in_metres.frame = Frame::kMetres;
  EXPECT_EQ(ids_of(recording_of(load_recording({a, b}, in_metres))), (Ids{"a", "b"}));
}

TEST_F(SeveralLogs, WithHeightsOfTwoKindsAreNotMixed) {
  const std::string table =
      write("t.csv", "id,unix_time_s,lon,lat,height_ellipsoid_m\nc,5,8,47,3\n");
  const auto loaded = load_recording({write("a.ulg", small_log().bytes()), table}, {});
  expect_error(loaded, {ErrorCode::kInvalidArgument, table, "above mean sea level"});
}

}  // namespace
}  // namespace beespace::io
