// How UTC differs from the time since a drone was switched on, by what its receiver of satellites
// says: what makes one clock of the logs of several drones.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::io {

struct SatelliteClock {
  std::int64_t ahead_micros = 0;    // the median
  std::uint64_t spread_micros = 0;  // in which nine of ten of the differences lie
  std::size_t samples = 0;
};

// Of UTC less the drone's own time, in microseconds; nothing of none.
std::optional<SatelliteClock> satellite_clock(std::vector<std::int64_t> ahead);

// Microseconds since 1970 (UTC) of a time of GPS; nothing of what is no week of it since 2012.
std::optional<std::int64_t> utc_of_gps(double week, double milliseconds);

// Where the times of GPS disagree by more than a second; `log` is what it is called.
std::optional<Error> contradiction(const SatelliteClock& clock, std::string_view log);

// Says how the clock of the source was set, and of several that it may be off.
void tell_clock(const std::optional<SatelliteClock>& clock, RecordingAssembly& assembly);

}  // namespace beespace::io
