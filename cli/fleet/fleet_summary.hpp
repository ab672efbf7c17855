// What `beespace fleet` tells people of its answer.
#pragma once

#include "cli/fleet/fleet_output.hpp"

#include <string>

namespace beespace::cli {

// How many were compared, who was not, and for how long it is not known where; how far they
// strayed, and who the farthest; and the figures to plan with, but of a show, whose operators do
// not.
std::string fleet_summary(const FleetAnswer& answer);

}  // namespace beespace::cli
