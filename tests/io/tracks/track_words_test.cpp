#include "io/table/column_names.hpp"
#include "io/tracks/track_columns.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace beespace::io {
namespace {

ColumnMeaning read_track_word(std::string_view name) {
  return read_column_name(track_columns(), name);
}

bool is_time(std::string_view name, Unit unit) {
  const ColumnMeaning word = read_track_word(name);
  return word.role == Role::kTime && word.unit == unit && word.foreign_unit.empty();
}

bool is_velocity(std::string_view name, Role part) {
  const ColumnMeaning word = read_track_word(name);
  return word.role == part && word.foreign_unit.empty();
}

TEST(TrackWords, TimesSayTheirUnit) {
  EXPECT_TRUE(is_time("time_s", Unit::kSecond));
  EXPECT_TRUE(is_time("t [s]", Unit::kSecond));
  EXPECT_TRUE(is_time("seconds", Unit::kSecond));
  EXPECT_TRUE(is_time("Time_msec", Unit::kMillisecond));
  EXPECT_TRUE(is_time("Time [msec]", Unit::kMillisecond));
  EXPECT_TRUE(is_time("timestampMs", Unit::kMillisecond));
  EXPECT_TRUE(is_time("timestamp_us", Unit::kMicrosecond));
  EXPECT_TRUE(is_time("TimeUS", Unit::kMicrosecond));
  EXPECT_TRUE(is_time("t [\xC2\xB5s]", Unit::kMicrosecond));
  EXPECT_TRUE(is_time("t [\xCE\xBCs]", Unit::kMicrosecond));
  EXPECT_TRUE(is_time("time_ns", Unit::kNanosecond));
}

TEST(TrackWords, TimesMayNotSayTheirUnit) {
  for (const std::string_view name : {"time", "t", "Timestamp", "ts", "Zeit"}) {
    EXPECT_EQ(read_track_word(name).unit, Unit::kUnstated) << name;
  }
  EXPECT_TRUE(is_time("time", Unit::kUnstated));
}

TEST(TrackWords, TimesSince1970SaySo) {
  EXPECT_TRUE(read_track_word("unix_time_s").since_1970);
  EXPECT_TRUE(read_track_word("time since epoch [ms]").since_1970);
  EXPECT_FALSE(read_track_word("time_s").since_1970);
}

TEST(TrackWords, UnitsThatAreNotReadAreKept) {
  EXPECT_EQ(read_track_word("time [min]").foreign_unit, "min");
  EXPECT_EQ(read_track_word("time_h").foreign_unit, "h");
  EXPECT_EQ(read_track_word("vx [km/h]").unit, Unit::kKilometrePerHour);
  EXPECT_EQ(read_track_word("vel_e_kt").unit, Unit::kKnot);
  EXPECT_EQ(read_track_word("vx_km").foreign_unit, "km");
  EXPECT_EQ(read_track_word("ground speed [kt]").role, Role::kGroundSpeed);
  EXPECT_EQ(read_track_word("ground speed [kt]").unit, Unit::kKnot);
  EXPECT_EQ(read_track_word("vertical_rate").role, Role::kClimb);
  EXPECT_EQ(read_track_word("track [deg]").role, Role::kTrack);
  EXPECT_EQ(read_track_word("track_id").role, Role::kId);
}

TEST(TrackWords, VelocitiesSayTheirAxis) {
  EXPECT_TRUE(is_velocity("vx", Role::kVelocityX));
  EXPECT_TRUE(is_velocity("v_y", Role::kVelocityY));
  EXPECT_TRUE(is_velocity("velocity z [m/s]", Role::kVelocityZ));
  EXPECT_TRUE(is_velocity("ve", Role::kVelocityEast));
  EXPECT_TRUE(is_velocity("velocity_north", Role::kVelocityNorth));
  EXPECT_TRUE(is_velocity("speed up (m/s)", Role::kVelocityUp));
  EXPECT_TRUE(is_velocity("vel_d_m_s", Role::kVelocityDown));
  EXPECT_TRUE(is_velocity("vu_mps", Role::kVelocityUp));
}

TEST(TrackWords, BeesHaveIds) {
  for (const std::string_view name : {"id", "bee", "Drone", "uav", "icao24", "drone_id", "name"}) {
    EXPECT_EQ(read_track_word(name).role, Role::kId) << name;
  }
}

TEST(TrackWords, PositionsAreThoseOfPoints) {
  EXPECT_EQ(read_track_word("x").role, Role::kX);
  EXPECT_EQ(read_track_word("uav_lat").role, Role::kLatitude);
  EXPECT_EQ(read_track_word("alt [ft]").unit, Unit::kFoot);
}

TEST(TrackWords, WhenAPositionWasMeasured) {
  for (const std::string_view name : {"lastposupdate", "last_position", "time_position"}) {
    EXPECT_EQ(read_track_word(name).role, Role::kPositionTime) << name;
  }
  EXPECT_EQ(read_track_word("lastcontact").role, Role::kNone);
}

TEST(TrackWords, WhatIsNotUnderstoodToItsLastWordIsNothing) {
  for (const std::string_view name :
       {"", "gps_time_local", "v", "velocity", "ground speeds", "vxy", "vx_error", "acc_x",
        "x_time_s", "vx vy", "s", "us", "ms", "drone color"}) {
    EXPECT_EQ(read_track_word(name).role, Role::kNone) << name;
  }
}

// As EuRoC's ground truth has it.
TEST(TrackWords, AnAttitudeIsNoPlace) {
  const Recording recording = recording_of(record(
      "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], "
      "q_RS_z [], v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1]\n"
      "1403636580838555648,4.5,-1.5,0.75,0.5,-0.1,-0.8,-0.1,0.5,0.25,0\n"
      "1403636581838555648,5.0,-1.25,0.75,0.5,-0.1,-0.8,-0.1,0.5,0.25,0\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  const Fix& fix = recording.bees[0].fixes.back();
  EXPECT_EQ(fix.position.x, 5.0);
  EXPECT_EQ(fix.position.y, -1.25);
  EXPECT_EQ(fix.position.z, 0.75);
  EXPECT_NEAR(fix.time_s, 1403636581.838555648, 1e-6);
}

// As Vectronic's collars have them.
TEST(TrackWords, PlacesOfTheEarthBesideLongitudeAndLatitudeAreTheSame) {
  const std::string text =
      "CollarID,UTC_Date,UTC_Time,ECEF_X [m],ECEF_Y [m],ECEF_Z [m],Latitude [\u00b0],Longitude "
      "[\u00b0],Height [m]\n"
      "12345,25.03.2023,20:00:00,4300000,840000,4600000,46.499489,11.00051,1207\n"
      "12345,25.03.2023,21:00:00,4300000,840000,4600000,46.5,11.25,1207\n";
  const Recording recording = recording_of(record(text));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  ASSERT_EQ(ids_of(recording), std::vector<std::string>{"12345"});
  EXPECT_EQ(recording.bees[0].fixes[1].position.x, 11.25);
  EXPECT_EQ(recording.bees[0].fixes[1].position.z, 1207.0);
}

}  // namespace
}  // namespace beespace::io
