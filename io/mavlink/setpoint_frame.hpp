// SET_POSITION_TARGET_LOCAL_NED (84) as a frame of MAVLink 2: where a vehicle shall be, and how
// fast.
//
// Input x is east, y north, z up (ENU); in the frame x is north, y east, z down (NED). Numbers are
// floats there: of a kilometre they leave out less than a tenth of a millimetre.
// Source: mavlink.io, common message set; "Packet Serialization".
#pragma once

#include <beespace/mover.hpp>

#include <cstdint>
#include <string>

namespace beespace::io {

struct SetpointFrame {
  std::uint8_t sequence = 0;  // of all frames of the sender, modulo 256
  std::uint8_t target_system = 0;
  std::uint32_t time_boot_ms = 0;
  Mover setpoint = {};
  bool velocity_only = false;  // the position counts for nothing
};

void append_setpoint_frame(std::string& out, const SetpointFrame& frame);

}  // namespace beespace::io
