// What came of a simulation, for programs.
#pragma once

#include "cli/simulate/simulated_flight.hpp"

#include <string>
#include <vector>

namespace beespace::cli {

// A document.
std::string simulate_json(const SimulatedFlight& flight);

// One of several flights, and all of them as a document.
std::string run_as_json(const SimulatedFlight& flight);
std::string sweep_json(const std::vector<std::string>& runs);

}  // namespace beespace::cli
