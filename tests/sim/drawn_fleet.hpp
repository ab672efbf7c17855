// A fleet at random: what it is told, what is wrong with it, and where it flies. All that a fleet
// may be is drawn together, over decades, so that what no one thought of meets.
#pragma once

#include "scenes/missions.hpp"
#include "sim/fleet_options.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace beespace::sim {

struct DrawnFleet {
  FleetOptions options;
  scenes::Mission mission;
  int ticks = 0;
  std::string text;  // for people
};

// The same for the same seed. Nothing: figures that a planner refuses, or a tube that is too wide
// to be flown.
std::optional<DrawnFleet> draw_fleet(std::uint64_t seed);

}  // namespace beespace::sim
