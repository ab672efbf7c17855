// What messages of MAVLink say of a place: where a drone or an aircraft is and how fast, in units
// and axes of ours. Source: mavlink.io, common message set.
#pragma once

#include "io/mavlink/mavlink_frame.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace beespace::io {

// Of the sender's own places the later one is the worse; `kOfAnother` is of an aircraft that the
// sender has heard.
enum class PlaceBy : std::uint8_t {
  kGlobal,     // GLOBAL_POSITION_INT (33)
  kUtm,        // UTM_GLOBAL_POSITION (340)
  kSatellite,  // GPS_RAW_INT (24)
  kLocal,      // LOCAL_POSITION_NED (32)
  kOfAnother,  // ADSB_VEHICLE (246)
};
inline constexpr std::size_t kPlacesBy = 5;

struct MavlinkPosition {
  PlaceBy by = PlaceBy::kGlobal;
  // Longitude, latitude in degrees, height in metres above mean sea level, of another aircraft as
  // its receiver tells it; of message 32 metres east, north and up of the drone's own origin.
  Point position = {};
  Velocity velocity = {};  // m/s east, north, up; not-a-number where unknown
  // Whether the sender says that it knows the place; (0, 0) on the Earth is none.
  bool known = true;
  std::uint32_t address = 0;  // of another aircraft: that of ICAO
  std::string name = {};      // of another aircraft its callsign; of message 340 whose place it is
  double age_s = 0.0;         // how old it was when it was sent, as far as that is said
  // Above where it took off, by its own word; not-a-number where it does not say.
  double above_home_m = std::numeric_limits<double>::quiet_NaN();
  // Of the sender's own place: when that was by its clock, in microseconds from any zero.
  std::optional<std::int64_t> sent_us = {};

  [[nodiscard]] bool global() const { return by != PlaceBy::kLocal; }
};

// Nothing for other messages. Their numbers are not checked: those of message 32 may not be finite.
std::optional<MavlinkPosition> read_mavlink_position(const MavlinkFrame& frame);

// "abcdef", as readsb writes addresses.
std::string address_text(std::uint32_t address);

}  // namespace beespace::io
