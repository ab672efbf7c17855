// A fleet that is not exact, flown and written down, and what came of it.
#pragma once

#include "cli/console/exit_code.hpp"
#include "cli/simulate/simulate_mission.hpp"
#include "cli/simulate/simulate_request.hpp"
#include "io/bytes/atomic_output.hpp"

#include <beespace/result.hpp>

namespace beespace::cli {

// Null for no recording. `truth` gets true positions, `nominal` nominal ones.
Result<ExitCode> fly_fleet(const SimulateRequest& request, MissionToFly mission,
                           io::AtomicOutput* truth, io::AtomicOutput* nominal);

}  // namespace beespace::cli
