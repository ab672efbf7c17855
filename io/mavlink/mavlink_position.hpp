// What MAVLink messages 32 and 33 say: where a drone is and how fast, in units and axes of ours.
#pragma once

#include "io/mavlink/mavlink_frame.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <optional>

namespace beespace::io {

struct MavlinkPosition {
  bool global = false;
  // Of message 33 (GLOBAL_POSITION_INT) longitude, latitude in degrees, height above mean sea level
  // in metres; of message 32 (LOCAL_POSITION_NED) metres east, north and up of the drone's own
  // origin.
  Point position = {};
  Velocity velocity = {};  // m/s east, north, up; not-a-number where unknown
};

// Nothing for other messages. Their numbers are not checked: those of message 32 may not be finite.
std::optional<MavlinkPosition> read_mavlink_position(const MavlinkFrame& frame);

}  // namespace beespace::io
