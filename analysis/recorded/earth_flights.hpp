// Flights in degrees, for limits of speed, acceleration and height of one bee alone: unrolled on a
// plane, from fix to fix so far to the east, so far to the north and so far up. How far apart two
// bees are does not follow from them.
#pragma once

#include "analysis/recorded/flights.hpp"
#include "io/recording/recording.hpp"

#include <beespace/result.hpp>
#include <beespace/verify_path.hpp>

#include <cstddef>

namespace beespace::analysis {

struct EarthFlight {
  Flight places;      // straight from fix to fix
  Flight velocities;  // the same pieces, with the velocities that were logged, evenly changing
                      // between fixes; empty where none is logged, or is not looked at
};

// Where a bee has velocities that are all zero, although it moves, it has none. Errors: those of
// to_ecef().
Result<EarthFlight> earth_flight_of(const io::Recording& recording, std::size_t bee,
                                    bool with_velocities, double max_gap_s);

// Whether any bee has velocities.
bool logs_velocities(const io::Recording& recording);

// What limits find of it: speeds by both, whatever is faster; heights by places; accelerations by
// velocities, which are measured, where there are some, and otherwise by how places turn. Errors:
// those of check_path().
Result<PathCheck> check_earth_flight(const EarthFlight& flight, const PathLimits& limits);

}  // namespace beespace::analysis
