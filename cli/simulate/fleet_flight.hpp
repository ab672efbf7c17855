// A fleet that is not exact, flown and written down, and what came of it.
#pragma once

#include "cli/console/exit_code.hpp"
#include "cli/simulate/simulate_mission.hpp"
#include "cli/simulate/simulate_request.hpp"
#include "io/bytes/atomic_output.hpp"

#include <beespace/result.hpp>

namespace beespace::cli {

// What is written of a flight; null for what is not.
struct FleetOutputs {
  io::AtomicOutput* truth = nullptr;    // true positions
  io::AtomicOutput* nominal = nullptr;  // nominal ones
  io::AtomicOutput* log = nullptr;      // what the planner said
};

Result<ExitCode> fly_fleet(const SimulateRequest& request, MissionToFly mission,
                           const FleetOutputs& outputs);

}  // namespace beespace::cli
