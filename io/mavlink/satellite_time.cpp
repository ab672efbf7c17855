#include "io/mavlink/satellite_time.hpp"

#include "io/mavlink/mavlink_payload.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::io {
namespace {

// A vehicle that has never heard of satellites counts from its start, or from 1970.
constexpr std::int64_t kFirstMicros = 978'307'200'000'000;   // 2001
constexpr std::int64_t kLastMicros = 4'102'444'800'000'000;  // 2100
constexpr std::int64_t kAgreeMicros = 250'000;
constexpr std::size_t kOneIn = 4;

}  // namespace

bool is_unix_time(std::int64_t micros) {
  return micros >= kFirstMicros && micros <= kLastMicros;
}

std::optional<SatelliteTime> read_satellite_time(const MavlinkFrame& frame) {
  if (frame.message != kSystemTime) return std::nullopt;
  const MavlinkPayload payload(frame.payload);
  const auto unix_us = static_cast<std::int64_t>(payload.unsigned64(0));
  const std::uint32_t boot_ms = payload.unsigned32(8);
  if (!is_unix_time(unix_us) || boot_ms == 0) return std::nullopt;
  return SatelliteTime{std::int64_t{boot_ms} * 1000, unix_us};
}

std::optional<std::int64_t> ahead_of_satellites_us(const std::vector<SatelliteTime>& told,
                                                   const std::vector<std::int64_t>& at_us) {
  if (told.empty()) return std::nullopt;
  std::vector<std::int64_t> ahead;
  for (std::size_t i = 0; i < told.size(); ++i) ahead.push_back(at_us[i] - told[i].unix_us);
  const auto middle = ahead.begin() + static_cast<std::ptrdiff_t>(ahead.size() / 2);
  std::nth_element(ahead.begin(), middle, ahead.end());
  const std::int64_t median = *middle;
  const auto others = std::count_if(ahead.begin(), ahead.end(), [median](std::int64_t one) {
    return one > median + kAgreeMicros || one < median - kAgreeMicros;
  });
  if (kOneIn * static_cast<std::size_t>(others) > ahead.size()) return std::nullopt;
  return median;
}

}  // namespace beespace::io
