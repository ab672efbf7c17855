// What came of a simulation, for people.
#pragma once

#include "cli/simulate/simulated_flight.hpp"

#include <string>

namespace beespace::cli {

std::string simulate_summary(const SimulatedFlight& flight);

// Of several flights with falling spacing: what they have in common with the names of the columns,
// and a row for each.
std::string sweep_head(const SimulateRequest& request);
std::string sweep_row(const SimulatedFlight& flight);

}  // namespace beespace::cli
