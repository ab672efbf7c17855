// What of a fleet's promise was broken in a flight.
#pragma once

#include "tests/sim/drawn_fleet.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace beespace::sim {

struct JudgedFleet {
  // Sentences; none: all held.
  std::vector<std::string> broken;
  std::uint64_t agents = 0;
  std::uint64_t agent_ticks = 0;
  std::uint64_t arrived = 0;
  std::uint64_t named = 0;
};

// Flies it to its end. While agents keep their figures, no two of them come too close, nor one to a
// fence; none leaves its tube, is named, or has a message of it refused; and none is without
// certificate unless one is out of its contract.
JudgedFleet judge_fleet(const DrawnFleet& fleet);

}  // namespace beespace::sim
