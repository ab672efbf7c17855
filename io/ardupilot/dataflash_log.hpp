// What a DataFlash log of ArduPilot says of where its vehicle was, and whether it had landed: the
// messages POS, GPS, XKF1, XKF4, EV, STAT and MSG, in units of ours.
// Source: ardupilot.org, "Onboard Message Log Messages".
#pragma once

#include "io/flight_logs/log_losses.hpp"
#include "io/flight_logs/satellite_clock.hpp"
#include "io/flight_logs/satellite_fixes.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::io {

// One message of POS: where the vehicle was by its estimator. Or of GPS.
struct DataflashPlace {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  std::uint64_t micros = 0;  // since the vehicle was switched on
  Point position = {};       // degrees, and m above mean sea level
  double above_home_m = kUnknown;
  Velocity velocity = {kUnknown, kUnknown, kUnknown};  // m/s east, north, up
  std::size_t core = 0;                                // of its estimator, that it heeds
  bool guessed = false;                                // by its own word
};

// From then on; the first one since the log begins.
struct DataflashLanding {
  std::uint64_t micros = 0;
  bool landed = false;
};

struct DataflashLog {
  std::vector<DataflashPlace> places;
  bool by_gps = false;                     // by its first receiver alone: there is no POS
  std::vector<DataflashLanding> landings;  // nothing where it says nothing of the kind
  SatelliteFixes fixes;
  std::optional<SatelliteClock> clock;  // nothing where GPS never said a time
  bool on_surface = false;              // a rover or a boat, by its own word
  LogLosses losses;
};

// `bytes` begin as is_dataflash_log() says. Errors: kCorrupt where POS is defined, and not as a
// time and a place.
Result<DataflashLog> read_dataflash_log(std::string_view bytes);

}  // namespace beespace::io
