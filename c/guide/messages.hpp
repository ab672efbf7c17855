// What planner and agents tell each other, from C to C++ and back.
#pragma once

#include <beespace.h>
#include <beespace/command.hpp>
#include <beespace/fleet.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>

namespace beespace::c {

inline Point point_of(const double (&numbers)[3]) {
  return {numbers[0], numbers[1], numbers[2]};
}
inline Velocity velocity_of(const double (&numbers)[3]) {
  return {numbers[0], numbers[1], numbers[2]};
}
// NULL: perfect; as one of zeros.
Result<FleetFigures> figures_of(const beespace_fleet_figures* figures);
Result<LinkFigures> link_of(const beespace_link_figures* link);

Result<Command> command_of(const beespace_command* command, const char* name);
beespace_command c_command_of(const Command& command);
Result<Acknowledgement> acknowledgement_of(const beespace_acknowledgement* acknowledgement);
beespace_acknowledgement c_acknowledgement_of(const Acknowledgement& acknowledgement);
Result<AgentReport> report_of(const beespace_agent_report* report);
Result<StoredBranch> stored_of(const beespace_stored_branch* stored);
beespace_stored_branch c_stored_of(const StoredBranch& stored);

}  // namespace beespace::c
