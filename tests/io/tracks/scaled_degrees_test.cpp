// Tables as tools of MAVLink and PX4 write them: degrees as whole numbers of 1e-7.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

// As mavlogdump.py writes GLOBAL_POSITION_INT.
std::string log_of(const std::string& second_lat) {
  const std::string name = "GLOBAL_POSITION_INT.";
  return "timestamp," + name + "lat," + name + "lon," + name + "alt\n" +
         "1716300000.25,473977420,85455940,488000\n1716300000.5," + second_lat +
         ",-85455940,488100\n";
}

RecordingOptions of_mavlink() {
  RecordingOptions options;
  options.time_unit = Unit::kSecond;
  options.units.height = Unit::kMillimetre;
  return options;
}

TEST(ScaledDegrees, AreKnownByTheirSize) {
  const auto recording = recording_of(record(log_of("-1"), of_mavlink()));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.bees[0].fixes,
            (std::vector<Fix>{{1716300000.25, {8.5455940, 47.3977420, 488.0}},
                              {1716300000.5, {-8.5455940, -0.0000001, 488.1}}}));
  EXPECT_TRUE(has_note(recording, "whole numbers of 1e-7 degrees"));
}

TEST(ScaledDegrees, AreAllWhole) {
  std::string log = log_of("1");
  for (int k = 0; k < 20; ++k) {
    log += std::to_string(1716300001 + k) + ",473977420,85455940,488000\n";
  }
  expect_error(
      record(log + "1716300030,47.39,85455940,488000\n", of_mavlink()),
      {ErrorCode::kMalformedRecord, "bees.csv:24:2", "'47.39' is no whole number of 1e-7"});
  // Beyond what degrees can be, scaled or not.
  const auto too_large = record(log_of("973977420"), of_mavlink());
  ASSERT_FALSE(too_large);
  EXPECT_EQ(too_large.error().code, ErrorCode::kInvalidLongitude);
}

TEST(ScaledDegrees, AreNotTakenForMetres) {
  RecordingOptions options = of_mavlink();
  options.frame = Frame::kMetres;
  expect_error(record(log_of("473977420"), options),
               {ErrorCode::kUnknownFrame, "bees.csv:1", "no coordinate in metres"});
  options.columns = "time=1,x=3,y=2,z=4";
  expect_error(record(log_of("473977420"), options),
               {ErrorCode::kUnknownFrame, "bees.csv:1", "no coordinate in metres"});
}

// Whole heights beside them are in millimetres where the message is known, and asked for otherwise.
TEST(ScaledDegrees, HaveHeightsInMillimetresBesideThem) {
  RecordingOptions seconds;
  seconds.time_unit = Unit::kSecond;
  expect_error(record(log_of("-1"), seconds),
               {ErrorCode::kInvalidArgument, "bees.csv:1:4",
                "in which unit? Most messages of MAVLink and PX4 have millimetres there, some "
                "metres; say it with --units height=mm or height=m"});
  const std::string low = "1716300000.25,473977420,85455940,9000,20000\n";
  for (const std::string other : {"GLOBAL_POSITION_INT.relative_alt", "alt_ellipsoid"}) {
    const auto recording =
        recording_of(record("timestamp,lat,lon,alt," + other + "\n" + low, seconds));
    EXPECT_EQ(recording.bees[0].fixes[0].position.z, other == "alt_ellipsoid" ? 20.0 : 9.0);
    EXPECT_EQ(recording.units[0].unit, Unit::kMillimetre);
  }
  const std::string aircraft =
      "timestamp,ICAO_address,lat,lon,altitude,callsign\n"
      "1716300000,4242,473977420,85455940,9000000,DLH1\n";
  expect_error(record(aircraft, seconds),
               {ErrorCode::kInvalidArgument, "bees.csv:1:5", "in mm: --units height=mm"});
  // As ulog2csv writes vehicle_gps_position of PX4 1.13.
  const auto px4 =
      recording_of(record("timestamp,time_utc_usec,lat,lon,alt,alt_ellipsoid\n"
                          "12300000,1795000000000000,470000045,189992088,25000,-3000\n",
                          columns_are("time=2", Unit::kUnstated)));
  EXPECT_EQ(px4.bees[0].fixes[0].position.z, -3.0);
  // Who says the unit knows it, and so does a header; fractions are no millimetres.
  seconds.units.height = Unit::kMetre;
  EXPECT_EQ(recording_of(record(log_of("-1"), seconds)).bees[0].fixes[0].position.z, 488000.0);
  seconds.units.height = Unit::kUnstated;
  EXPECT_EQ(recording_of(record("time,lat,lon,alt_m\n1,473977420,85455940,488\n", seconds))
                .bees[0]
                .fixes[0]
                .position.z,
            488.0);
  EXPECT_EQ(recording_of(record("time,lat,lon,alt\n1,473977420,85455940,488.5\n", seconds))
                .bees[0]
                .fixes[0]
                .position.z,
            488.5);
}

TEST(TimesSinceTheStart, OfSeveralVehiclesCannotBeCompared) {
  const TemporaryFolder folder;
  const std::string table =
      "time_boot_ms,lat,lon,alt_m\n34000,47.39,8.5,488\n35000,47.39,8.5,488\n";
  const std::string first = folder.write("a.csv", table);
  const std::string second = folder.write("b.csv", table);
  EXPECT_TRUE(load_recording({first}));
  expect_error(load_recording({first, second}),
               {ErrorCode::kInvalidArgument, second, "a zero of each vehicle's own"});
  RecordingOptions options;
  options.time_unit = Unit::kMillisecond;  // which the header says, too
  expect_error(load_recording({first, second}, options),
               {ErrorCode::kInvalidArgument, second, "say so with --one-clock"});
  options.one_clock = true;
  EXPECT_TRUE(load_recording({first, second}, options));
}

}  // namespace
}  // namespace beespace::io
