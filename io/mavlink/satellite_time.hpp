// How late a link always is: what the least delay of messages cannot tell (boot_clock.hpp).
//
// A vehicle that has the time of its satellites tells it beside its own clock (SYSTEM_TIME, message
// 2). So of two such vehicles it is known how much longer the messages of one took, also where all
// of them took as long.
#pragma once

#include "io/mavlink/mavlink_frame.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::io {

// Two clocks of a vehicle at one moment.
struct SatelliteTime {
  std::int64_t sent_us = 0;  // by its own, since it was started
  std::int64_t unix_us = 0;  // by its satellites
};

// Whether a number of microseconds is a time since 1970, and not since a start.
bool is_unix_time(std::int64_t micros);

// Nothing for other messages, and where the sender does not know the time.
std::optional<SatelliteTime> read_satellite_time(const MavlinkFrame& frame);

// The time of a log less that of satellites, as the messages of one vehicle show it: with what the
// fastest of them took. `at_us` are their moments by the clock of the log. Nothing where they do
// not agree, as where the vehicle was told the time in flight.
std::optional<std::int64_t> ahead_of_satellites_us(const std::vector<SatelliteTime>& told,
                                                   const std::vector<std::int64_t>& at_us);

}  // namespace beespace::io
