// What the planner of a fleet said, in the page's JSON: member "fleet" of a recording.
#pragma once

#include "io/json/json_writer.hpp"
#include "report/columns.hpp"
#include "report/fleet_facts.hpp"

namespace beespace::report {

// `begins_s`: the time of the recording that the page counts from.
void write_fleet(io::JsonWriter& json, const FleetFacts& fleet, double begins_s, Columns& columns);

}  // namespace beespace::report
