// What the heights of an input are.
#pragma once

#include <cstdint>
#include <string_view>

namespace beespace::io {

// What a height is counted from.
enum class HeightDatum : std::uint8_t {
  kUnstated,      // the file does not say
  kEllipsoid,     // WGS84
  kMeanSeaLevel,  // a geoid
  kPressure,      // barometric, of the standard atmosphere
  kHome,          // the place of take-off
};

// What to say of several whose heights are each above its own take-off.
inline constexpr std::string_view kOwnGrounds =
    "heights are counted from where each one took off, or from the ground below it: those of "
    "several cannot be compared; take heights above sea level, or, if all took off at one height, "
    "say so with --crs wgs84";

// Of those who tell several heights, such as aircraft: never some of one kind and some of the
// other.
enum class HeightSource : std::uint8_t {
  kAuto,            // geometric where the format has it, otherwise by pressure
  kGeometric,       // by satellites, above the WGS84 ellipsoid
  kPressure,        // of the standard atmosphere
  kRatherPressure,  // by pressure where the format has it, otherwise as kAuto: minima are of these
};

}  // namespace beespace::io
