// What the name of a column says beyond the position: time, velocity, or whose record it is.
//
// As in header_words.hpp, a name is understood to its last word or not at all: "time_s",
// "Time [msec]", "timestamp_us", "vx", "velocity_east", "vel_n_m_s", "drone".
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/units/units.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

enum class TrackRole : std::uint8_t {
  kNone,
  kId,
  kTime,
  kVelocity,  // along an axis
  kGroundSpeed,
  kTrack,  // the direction over ground, in degrees clockwise from true north
  kClimb,
};

// Along what a velocity is given.
enum class VelocityAxis : std::uint8_t { kX, kY, kZ, kEast, kNorth, kUp, kDown };

struct TrackWord {
  TrackRole role = TrackRole::kNone;
  TimeUnit unit = TimeUnit::kAuto;  // of a time; kAuto: it does not say
  bool since_1970 = false;          // of a time: "unix_time_s"
  VelocityAxis axis = VelocityAxis::kX;
  Unit speed_unit = Unit::kUnstated;  // of what is a speed
  std::string foreign_unit = {};      // a unit that is not read: "min", of a speed "km", ...
};

TrackWord read_track_word(std::string_view name);

// "seconds", "milliseconds", ...
std::string_view unit_name(TimeUnit unit);

// How many of the unit are a second: 1, 1e3, 1e6, 1e9.
double units_per_second(TimeUnit unit);

}  // namespace beespace::io
