// The rows of the table of prevention that holds in the air: each a fleet with something wrong.
#pragma once

#include "sim/fleet_options.hpp"

#include <string>
#include <vector>

namespace beespace::bench {

struct PreventionRow {
  std::string name;
  sim::FleetOptions fleet;
  // How many points of arrivals it may be below its baseline; below zero: it is reported only.
  double within_points = -1.0;
};

std::vector<PreventionRow> prevention_rows();

// All at once, at middle values.
sim::FleetOptions middle_values();

}  // namespace beespace::bench
