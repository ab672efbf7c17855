#include "io/mavlink/mavlink_position.hpp"

#include "io/frames/track_domain.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace beespace::io {
namespace {

// Both messages have this size.
constexpr std::size_t kPayload = 28;

// Little-endian numbers of a payload, behind whose end there are zeros: version 2 cuts them off.
class Payload {
 public:
  explicit Payload(std::string_view bytes) {
    std::copy_n(bytes.begin(), std::min(bytes.size(), kPayload), bytes_.begin());
  }

  [[nodiscard]] std::uint32_t unsigned32(std::size_t at) const {
    return unsigned16(at) | unsigned16(at + 2) << 16u;
  }
  [[nodiscard]] double signed32(std::size_t at) const {
    return static_cast<std::int32_t>(unsigned32(at));
  }
  [[nodiscard]] double signed16(std::size_t at) const {
    return static_cast<std::int16_t>(unsigned16(at));
  }
  [[nodiscard]] double float32(std::size_t at) const {
    return without_dust(static_cast<double>(std::bit_cast<float>(unsigned32(at))));
  }

 private:
  [[nodiscard]] std::uint32_t unsigned16(std::size_t at) const {
    const auto byte = [this](std::size_t i) {
      return std::uint32_t{static_cast<unsigned char>(bytes_[i])};
    };
    return byte(at) | byte(at + 1) << 8u;
  }

  std::array<char, kPayload> bytes_ = {};
};

// Turned from north, east, down; -0 is avoided where there is no climb.
Velocity from_north_east_down(double north, double east, double down) {
  return {east, north, 0.0 - down};
}

MavlinkPosition global_position(const Payload& payload) {
  constexpr double kPerDegree = 1e7;
  constexpr double kMillimetresPerMetre = 1000.0;
  constexpr double kCentimetresPerMetre = 100.0;
  MavlinkPosition found;
  found.global = true;
  found.position = {payload.signed32(8) / kPerDegree, payload.signed32(4) / kPerDegree,
                    payload.signed32(12) / kMillimetresPerMetre};
  found.velocity = from_north_east_down(payload.signed16(20) / kCentimetresPerMetre,
                                        payload.signed16(22) / kCentimetresPerMetre,
                                        payload.signed16(24) / kCentimetresPerMetre);
  return found;
}

MavlinkPosition local_position(const Payload& payload) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const auto known = [&payload](std::size_t at) {
    const double value = payload.float32(at);
    return std::isfinite(value) && in_motion_domain(value) ? value : kUnknown;
  };
  MavlinkPosition found;
  found.position = {payload.float32(8), payload.float32(4), 0.0 - payload.float32(12)};
  found.velocity = from_north_east_down(known(16), known(20), known(24));
  return found;
}

}  // namespace

std::optional<MavlinkPosition> read_mavlink_position(const MavlinkFrame& frame) {
  if (frame.message == kGlobalPositionInt) return global_position(Payload(frame.payload));
  if (frame.message == kLocalPositionNed) return local_position(Payload(frame.payload));
  return std::nullopt;
}

}  // namespace beespace::io
