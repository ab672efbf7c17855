#include "io/tracks/track_words.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace beespace::io {
namespace {

bool is_time(std::string_view name, TimeUnit unit) {
  const TrackWord word = read_track_word(name);
  return word.role == TrackRole::kTime && word.unit == unit && word.foreign_unit.empty();
}

bool is_velocity(std::string_view name, VelocityAxis axis) {
  const TrackWord word = read_track_word(name);
  return word.role == TrackRole::kVelocity && word.axis == axis && word.foreign_unit.empty();
}

TEST(TrackWords, TimesSayTheirUnit) {
  EXPECT_TRUE(is_time("time_s", TimeUnit::kSeconds));
  EXPECT_TRUE(is_time("t [s]", TimeUnit::kSeconds));
  EXPECT_TRUE(is_time("seconds", TimeUnit::kSeconds));
  EXPECT_TRUE(is_time("Time_msec", TimeUnit::kMilliseconds));
  EXPECT_TRUE(is_time("Time [msec]", TimeUnit::kMilliseconds));
  EXPECT_TRUE(is_time("timestampMs", TimeUnit::kMilliseconds));
  EXPECT_TRUE(is_time("timestamp_us", TimeUnit::kMicroseconds));
  EXPECT_TRUE(is_time("TimeUS", TimeUnit::kMicroseconds));
  EXPECT_TRUE(is_time("t [\xC2\xB5s]", TimeUnit::kMicroseconds));
  EXPECT_TRUE(is_time("t [\xCE\xBCs]", TimeUnit::kMicroseconds));
  EXPECT_TRUE(is_time("time_ns", TimeUnit::kNanoseconds));
}

TEST(TrackWords, TimesMayNotSayTheirUnit) {
  for (const std::string_view name : {"time", "t", "Timestamp", "ts", "Zeit"}) {
    EXPECT_EQ(read_track_word(name).unit, TimeUnit::kAuto) << name;
  }
  EXPECT_TRUE(is_time("time", TimeUnit::kAuto));
}

TEST(TrackWords, TimesSince1970SaySo) {
  EXPECT_TRUE(read_track_word("unix_time_s").since_1970);
  EXPECT_TRUE(read_track_word("time since epoch [ms]").since_1970);
  EXPECT_FALSE(read_track_word("time_s").since_1970);
}

TEST(TrackWords, UnitsThatAreNotReadAreKept) {
  EXPECT_EQ(read_track_word("time [min]").foreign_unit, "min");
  EXPECT_EQ(read_track_word("time_h").foreign_unit, "h");
  EXPECT_EQ(read_track_word("vx [km/h]").speed_unit, Unit::kKilometrePerHour);
  EXPECT_EQ(read_track_word("vel_e_kt").speed_unit, Unit::kKnot);
  EXPECT_EQ(read_track_word("vx_km").foreign_unit, "km");
  EXPECT_EQ(read_track_word("ground speed [kt]").role, TrackRole::kGroundSpeed);
  EXPECT_EQ(read_track_word("ground speed [kt]").speed_unit, Unit::kKnot);
  EXPECT_EQ(read_track_word("vertical_rate").role, TrackRole::kClimb);
  EXPECT_EQ(read_track_word("track [deg]").role, TrackRole::kTrack);
  EXPECT_EQ(read_track_word("track_id").role, TrackRole::kId);
}

TEST(TrackWords, VelocitiesSayTheirAxis) {
  EXPECT_TRUE(is_velocity("vx", VelocityAxis::kX));
  EXPECT_TRUE(is_velocity("v_y", VelocityAxis::kY));
  EXPECT_TRUE(is_velocity("velocity z [m/s]", VelocityAxis::kZ));
  EXPECT_TRUE(is_velocity("ve", VelocityAxis::kEast));
  EXPECT_TRUE(is_velocity("velocity_north", VelocityAxis::kNorth));
  EXPECT_TRUE(is_velocity("speed up (m/s)", VelocityAxis::kUp));
  EXPECT_TRUE(is_velocity("vel_d_m_s", VelocityAxis::kDown));
  EXPECT_TRUE(is_velocity("vu_mps", VelocityAxis::kUp));
}

TEST(TrackWords, BeesHaveIds) {
  for (const std::string_view name : {"id", "bee", "Drone", "uav", "icao24", "drone_id", "name"}) {
    EXPECT_EQ(read_track_word(name).role, TrackRole::kId) << name;
  }
}

TEST(TrackWords, WhatIsNotUnderstoodToItsLastWordIsNothing) {
  for (const std::string_view name :
       {"", "x", "lat", "time_position", "gps_time_local", "v", "velocity", "ground speeds", "vxy",
        "vx_error", "acc_x", "x_time_s", "vx vy", "s", "us", "ms", "drone color"}) {
    EXPECT_EQ(read_track_word(name).role, TrackRole::kNone) << name;
  }
}

}  // namespace
}  // namespace beespace::io
