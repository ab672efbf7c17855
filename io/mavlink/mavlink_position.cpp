#include "io/mavlink/mavlink_position.hpp"

#include "io/frames/track_domain.hpp"
#include "io/mavlink/mavlink_payload.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

namespace beespace::io {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kPerDegree = 1e7;
constexpr double kMillimetresPerMetre = 1000.0;
constexpr double kCentimetresPerMetre = 100.0;
constexpr unsigned kNoNumber = 0xFFFF;  // of speeds and directions

// Turned from north, east, down; -0 is avoided where there is no climb.
Velocity from_north_east_down(double north, double east, double down) {
  return {east, north, 0.0 - down};
}

Velocity along(double speed_mps, double hundredths_of_degree) {
  const double radians = hundredths_of_degree / 100.0 * std::numbers::pi / 180.0;
  return {speed_mps * std::sin(radians), speed_mps * std::cos(radians), kUnknown};
}

// Latitude and longitude in this order, then the height; in all messages on the Earth.
Point place_at(const MavlinkPayload& payload, std::size_t latitude, std::size_t height) {
  return {payload.signed32(latitude + 4) / kPerDegree, payload.signed32(latitude) / kPerDegree,
          payload.signed32(height) / kMillimetresPerMetre};
}

bool is_nowhere(const Point& place) {
  return place.x == 0.0 && place.y == 0.0;
}

// Zero is a field that is not set, and so is a time centuries away.
std::optional<std::int64_t> clock_us(std::uint64_t micros) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 53u;
  if (micros == 0 || micros > kMost) return std::nullopt;
  return static_cast<std::int64_t>(micros);
}

std::optional<std::int64_t> boot_clock_us(const MavlinkPayload& payload) {
  return clock_us(std::uint64_t{payload.unsigned32(0)} * 1000);
}

MavlinkPosition global_position(const MavlinkPayload& payload) {
  MavlinkPosition found;
  found.position = place_at(payload, 4, 12);
  found.velocity = from_north_east_down(payload.signed16(20) / kCentimetresPerMetre,
                                        payload.signed16(22) / kCentimetresPerMetre,
                                        payload.signed16(24) / kCentimetresPerMetre);
  found.above_home_m = payload.signed32(16) / kMillimetresPerMetre;
  found.known = !is_nowhere(found.position);
  found.sent_us = boot_clock_us(payload);
  return found;
}

MavlinkPosition local_position(const MavlinkPayload& payload) {
  const auto known = [&payload](std::size_t at) {
    const double value = payload.float32(at);
    return std::isfinite(value) && in_motion_domain(value) ? value : kUnknown;
  };
  MavlinkPosition found;
  found.by = PlaceBy::kLocal;
  found.position = {payload.float32(8), payload.float32(4), 0.0 - payload.float32(12)};
  found.velocity = from_north_east_down(known(16), known(20), known(24));
  found.sent_us = boot_clock_us(payload);
  return found;
}

MavlinkPosition satellite_position(const MavlinkPayload& payload) {
  constexpr unsigned kWithHeight = 3;  // GPS_FIX_TYPE_3D_FIX, and better ones
  MavlinkPosition found;
  found.by = PlaceBy::kSatellite;
  found.position = place_at(payload, 8, 16);
  found.velocity = {kUnknown, kUnknown, kUnknown};
  if (payload.unsigned16(24) != kNoNumber && payload.unsigned16(26) != kNoNumber) {
    found.velocity = along(payload.unsigned16(24) / kCentimetresPerMetre, payload.unsigned16(26));
  }
  found.known = payload.byte(28) >= kWithHeight && !is_nowhere(found.position);
  found.sent_us = clock_us(payload.unsigned64(0));
  return found;
}

MavlinkPosition utm_position(const MavlinkPayload& payload) {
  constexpr unsigned kTime = 1;
  constexpr unsigned kPlace = 4;
  constexpr unsigned kHeight = 8;
  constexpr unsigned kHorizontal = 32;
  constexpr unsigned kVertical = 64;
  const unsigned flags = payload.byte(69);
  MavlinkPosition found;
  found.by = PlaceBy::kUtm;
  found.position = place_at(payload, 8, 16);
  const auto speed = [&](std::size_t at, unsigned flag) {
    return (flags & flag) != 0 ? payload.signed16(at) / kCentimetresPerMetre : kUnknown;
  };
  found.velocity =
      from_north_east_down(speed(36, kHorizontal), speed(38, kHorizontal), speed(40, kVertical));
  found.name = payload.name(50, 18);
  found.known = (flags & kPlace) != 0 && (flags & kHeight) != 0 && !is_nowhere(found.position);
  if ((flags & kTime) != 0) found.sent_us = clock_us(payload.unsigned64(0));
  return found;
}

MavlinkPosition position_of_another(const MavlinkPayload& payload) {
  constexpr unsigned kPlace = 1;
  constexpr unsigned kHeight = 2;
  constexpr unsigned kHeading = 4;
  constexpr unsigned kSpeed = 8;
  constexpr unsigned kCallsign = 16;
  constexpr unsigned kClimb = 128;
  const unsigned flags = payload.unsigned16(22);
  const auto are_set = [flags](unsigned wanted) { return (flags & wanted) == wanted; };
  MavlinkPosition found;
  found.by = PlaceBy::kOfAnother;
  found.address = payload.unsigned32(0);
  found.position = place_at(payload, 4, 12);
  found.velocity = {kUnknown, kUnknown, kUnknown};
  if (are_set(kHeading | kSpeed)) {
    found.velocity = along(payload.unsigned16(18) / kCentimetresPerMetre, payload.unsigned16(16));
  }
  if (are_set(kClimb)) found.velocity.z = payload.signed16(20) / kCentimetresPerMetre;
  found.known = are_set(kPlace | kHeight) && !is_nowhere(found.position);
  found.age_s = payload.byte(37);
  if (are_set(kCallsign)) {
    const std::string_view text = payload.text(27, 8);
    const std::string_view filled = text.substr(0, text.find('\0'));
    found.name = filled.substr(0, filled.find_last_not_of(' ') + 1);
  }
  return found;
}

}  // namespace

std::optional<MavlinkPosition> read_mavlink_position(const MavlinkFrame& frame) {
  const MavlinkPayload payload(frame.payload);
  switch (frame.message) {
    case kGlobalPositionInt:
      return global_position(payload);
    case kLocalPositionNed:
      return local_position(payload);
    case kGpsRawInt:
      return satellite_position(payload);
    case kUtmGlobalPosition:
      return utm_position(payload);
    case kAdsbVehicle:
      return position_of_another(payload);
    default:
      return std::nullopt;
  }
}

std::string address_text(std::uint32_t address) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (int digit = 5; digit >= 0; --digit) text += kDigits[address >> 4 * digit & 0xFu];
  return text;
}

}  // namespace beespace::io
