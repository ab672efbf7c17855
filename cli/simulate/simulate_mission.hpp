// The mission that `beespace simulate` flies: of a scenario or of a file, and what stands in its
// way.
#pragma once

#include "cli/input/flight_names.hpp"
#include "cli/simulate/simulate_request.hpp"
#include "scenes/missions.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

struct MissionToFly {
  scenes::Mission mission;
  FlightNames names;
  std::vector<std::string> notes;  // what must be told
};

// Errors: those of reading; kInvalidArgument, or kMalformedRecord of a file, where two starts, or
// two goals, are closer than the threshold, or one is closer to an obstacle than the clearance.
Result<MissionToFly> mission_to_fly(const SimulateRequest& request);

// How far apart bees of a scenario begin at least, in metres: of a fleet that is not exact, with
// room for tubes and radii.
double least_spacing_m(const SimulateRequest& request);

}  // namespace beespace::cli
