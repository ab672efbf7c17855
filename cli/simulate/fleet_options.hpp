// Options of `beespace simulate` that tell what is wrong with a fleet.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/simulate/simulate_request.hpp"

#include <beespace/result.hpp>

namespace beespace::cli {

void add_fleet_options(Command& simulate, SimulateRequest& request);

// Whether any of them is given.
bool asks_for_fleet(const Command& command);

// Whether the fleet is flown by a Guide, and its truth apart from it: any of them is given. Error:
// kInvalidArgument, where they do not fit the others.
Result<bool> settle_fleet(const Command& command, SimulateRequest& request);

}  // namespace beespace::cli
