// What came of a simulation, for programs.
#pragma once

#include "cli/simulate/simulated_flight.hpp"
#include "io/json/json_writer.hpp"

#include <string>

namespace beespace::cli {

// A document.
std::string simulate_json(const SimulatedFlight& flight);

// A document of several flights, one after the other.
void begin_sweep(io::JsonWriter& json);
void write_run(io::JsonWriter& json, const SimulatedFlight& flight);
void end_sweep(io::JsonWriter& json);

}  // namespace beespace::cli
