#include "io/mavlink/telemetry_times.hpp"

#include <algorithm>
#include <limits>

namespace beespace::io {

void TelemetryTimes::take(const MavlinkFrame& frame, std::uint64_t index, std::int64_t came_us) {
  if (const auto time = read_satellite_time(frame)) {
    of_[frame.system].told.push_back({index, frame.component, came_us, *time});
  }
}

void TelemetryTimes::add_place(std::uint8_t system, std::uint8_t component, std::uint64_t index,
                               const SentMessage& message) {
  of_[system].component = component;
  of_[system].places.push_back({index, message});
}

void TelemetryTimes::settle() {
  for (std::size_t system = 0; system < kSystems; ++system) {
    if (of_[system].places.empty()) continue;
    if (settle(of_[system])) {
      by_own_clocks_ = true;
    } else {
      unbelieved_.push_back(system);
    }
  }
  compare_links();
}

// Whether the clock of a system is believed: then its places have moments, and perhaps it is known
// how far the log is ahead of satellites.
bool TelemetryTimes::settle(Of& of) {
  const auto tells_unix = [](const Place& place) { return is_unix_time(place.message.sent_us); };
  const bool by_unix = std::all_of(of.places.begin(), of.places.end(), tells_unix);
  const bool by_start = std::none_of(of.places.begin(), of.places.end(), tells_unix);
  std::vector<SentMessage> messages;
  std::vector<bool> is_place;
  std::vector<SatelliteTime> told;
  auto next = of.told.begin();
  const auto take_told = [&](std::uint64_t before) {
    for (; by_start && next != of.told.end() && next->index < before; ++next) {
      if (next->component != of.component) continue;
      messages.push_back({next->time.sent_us, next->came_us});
      is_place.push_back(false);
      told.push_back(next->time);
    }
  };
  for (const Place& place : of.places) {
    take_told(place.index);
    messages.push_back(place.message);
    is_place.push_back(true);
    if (by_unix) told.push_back({place.message.sent_us, place.message.sent_us});
  }
  take_told(std::numeric_limits<std::uint64_t>::max());

  const SentTimes times = sent_times(messages);
  if (!times.believed) return false;
  latest_us_ = std::max(latest_us_, times.latest_us);
  std::vector<std::int64_t> told_at_us;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    (is_place[i] ? of.at_us : told_at_us).push_back(times.at_us[i]);
  }
  of.ahead_us = ahead_of_satellites_us(told, by_unix ? of.at_us : told_at_us);
  return true;
}

// The quickest link is taken as it is, and what others take more is taken off.
void TelemetryTimes::compare_links() {
  std::int64_t least_us = std::numeric_limits<std::int64_t>::max();
  std::int64_t most_us = std::numeric_limits<std::int64_t>::min();
  for (const Of& of : of_) {
    if (!of.ahead_us) continue;
    least_us = std::min(least_us, *of.ahead_us);
    most_us = std::max(most_us, *of.ahead_us);
  }
  if (least_us > most_us) return;  // none
  satellites_differ_ = most_us - least_us > kMostApartMicros;
  if (satellites_differ_) return;
  log_ahead_us_ = least_us;
  by_satellites_ = most_us > least_us;
  if (!by_satellites_) return;
  const std::int64_t late_us = most_us - least_us;
  latest_us_ = std::max(latest_us_, late_us);
  for (std::size_t system = 0; system < kSystems; ++system) {
    Of& of = of_[system];
    if (!of.ahead_us) {
      if (!of.at_us.empty() && late_us > kLateMicros) perhaps_late_.push_back(system);
      continue;
    }
    for (std::int64_t& at_us : of.at_us) at_us -= *of.ahead_us - least_us;
  }
}

}  // namespace beespace::io
