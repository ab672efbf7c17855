// What the heights of an input are.
#pragma once

#include <cstdint>

namespace beespace::io {

// What a height is counted from.
enum class HeightDatum : std::uint8_t {
  kUnstated,      // the file does not say
  kEllipsoid,     // WGS84
  kMeanSeaLevel,  // a geoid
  kPressure,      // barometric, of the standard atmosphere
  kHome,          // the place of take-off
};

// Of those who tell several heights, such as aircraft: never some of one kind and some of the
// other.
enum class HeightSource : std::uint8_t {
  kAuto,            // geometric where the format has it, otherwise by pressure
  kGeometric,       // by satellites, above the WGS84 ellipsoid
  kPressure,        // of the standard atmosphere
  kRatherPressure,  // by pressure where the format has it, otherwise as kAuto: minima are of these
};

}  // namespace beespace::io
