// What a PX4 log says of where its drone was, and whether it had landed: the messages of four
// topics, in units of ours.
#pragma once

#include "io/flight_logs/satellite_clock.hpp"
#include "io/flight_logs/satellite_fixes.hpp"
#include "io/px4/ulog_walk.hpp"
#include "io/recording/landed_reports.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// One message of vehicle_global_position or vehicle_local_position.
struct Px4Place {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  std::uint64_t micros = 0;         // since the drone was switched on
  std::uint64_t sample_micros = 0;  // of what was measured for it; 0 where it is not said
  std::uint64_t message = 0;        // counted from 0, of its topic
  Point position = {};              // degrees and m above mean sea level; or east, north, up in m
  double ellipsoid_height = kUnknown;                  // m
  Velocity velocity = {kUnknown, kUnknown, kUnknown};  // m/s east, north, up
  bool known = true;                                   // it says so itself
  bool height_known = true;
  bool guessed = false;  // by inertia alone, or off by who knows how much
  bool height_guessed = false;
  // Of vehicle_local_position: longitude, latitude, height of its origin; not-a-number where the
  // drone does not know them.
  Point origin = {kUnknown, kUnknown, kUnknown};
};

struct Px4FlightLog {
  std::vector<Px4Place> global;
  std::vector<Px4Place> local;
  bool on_surface = false;                   // a rover or a boat, by its own word
  LandedReports landed;                      // of vehicle_land_detected, by `micros`
  SatelliteFixes fixes;                      // of vehicle_gps_position, by `micros`
  std::optional<SatelliteClock> clock;       // nothing where GPS never said a time
  std::vector<std::string> other_instances;  // of these topics, that are not taken
  UlogLosses losses;
};

// Errors: those of UlogWalk::begin(), kCorrupt for a topic that is there and whose definition
// cannot be read, or has no time or place.
Result<Px4FlightLog> read_flight_log(std::string_view bytes);

}  // namespace beespace::io
