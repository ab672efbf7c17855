#include "io/mavlink/live_telemetry_times.hpp"

#include "io/mavlink/satellite_time.hpp"
#include "io/mavlink/telemetry_times.hpp"

#include <algorithm>

namespace beespace::io {

void LiveTelemetryTimes::take(const MavlinkFrame& frame, std::int64_t came_us) {
  const auto time = read_satellite_time(frame);
  Of& of = of_[frame.system];
  if (!time || of.tells_unix) return;
  const std::int64_t at_us = of.clock.take({time->sent_us, came_us});
  if (of.clock.believed()) of.ahead_us = at_us - time->unix_us;
}

std::int64_t LiveTelemetryTimes::sent_at(std::uint8_t system, const SentMessage& message) {
  Of& of = of_[system];
  by_own_clocks_ = true;
  of.tells_places = true;
  const std::int64_t at_us = of.clock.take(message);
  if (!of.clock.believed()) {
    of.ahead_us.reset();
    return at_us;
  }
  if (is_unix_time(message.sent_us)) {
    of.tells_unix = true;
    of.ahead_us = at_us - message.sent_us;
  }
  const auto all = links();
  return all && of.ahead_us ? at_us - (*of.ahead_us - all->least_us) : at_us;
}

// Of those that tell the time of satellites; nothing where they cannot be compared.
std::optional<LiveTelemetryTimes::Links> LiveTelemetryTimes::links() const {
  std::optional<Links> links;
  for (const Of& of : of_) {
    if (!of.ahead_us || !of.tells_places) continue;
    if (!links) links = {*of.ahead_us, *of.ahead_us};
    links->least_us = std::min(links->least_us, *of.ahead_us);
    links->most_us = std::max(links->most_us, *of.ahead_us);
  }
  if (links && links->most_us - links->least_us > kMostApartMicros) links.reset();
  return links;
}

bool LiveTelemetryTimes::by_satellites() const {
  const auto all = links();
  return all && all->most_us > all->least_us;
}

std::vector<std::size_t> LiveTelemetryTimes::unbelieved() const {
  std::vector<std::size_t> systems;
  for (std::size_t system = 0; system < kSystems; ++system) {
    if (!of_[system].clock.believed()) systems.push_back(system);
  }
  return systems;
}

std::vector<std::size_t> LiveTelemetryTimes::perhaps_late() const {
  std::vector<std::size_t> systems;
  const auto all = links();
  if (!all || all->most_us - all->least_us <= kLateMicros) return systems;
  for (std::size_t system = 0; system < kSystems; ++system) {
    const Of& of = of_[system];
    if (of.tells_places && of.clock.believed() && !of.ahead_us) systems.push_back(system);
  }
  return systems;
}

}  // namespace beespace::io
