// The parts that several messages of a fleet have: branches, figures.
#pragma once

#include "io/fleet/fleet_fields.hpp"

#include <beespace/command.hpp>
#include <beespace/fleet.hpp>

namespace beespace::io {

// 'number', 'starts', 'path', 'ancestors'. A path has a row for each state: position and velocity,
// and of a loop on the ground the correction, as six numbers or nine.
void read_branch(FleetFields& fields, Command& branch);

// 'promised', 'tick', 'branch', where null is none.
void read_stored(FleetFields& fields, StoredBranch& stored);

// What is absent is as in `defaults`.
FleetFigures read_figures(FleetFields& fields, const FleetFigures& defaults);

}  // namespace beespace::io
