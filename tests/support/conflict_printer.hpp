// How conflicts and events are shown where a test fails.
#pragma once

#include <beespace/conflict.hpp>
#include <beespace/swarm.hpp>

#include <iomanip>
#include <ostream>

namespace beespace {

inline void PrintTo(const Conflict& c, std::ostream* out) {  // NOLINT: GoogleTest's name
  *out << std::setprecision(17) << c.first << " and " << c.second << " from " << c.begins_s
       << " to " << c.ends_s << " s, closest " << c.closest_m << " m at " << c.closest_s << " s"
       << (c.certain ? "" : ", perhaps");
}

inline void PrintTo(const SwarmEvent& e, std::ostream* out) {  // NOLINT: GoogleTest's name
  constexpr const char* kKinds[] = {"predicted", "entered", "closest passed", "left", "stale"};
  *out << std::setprecision(17) << kKinds[static_cast<std::size_t>(e.kind)] << ": " << e.first
       << " and " << e.second << " at " << e.time_s << " s, " << e.distance_m << " m, closest at "
       << e.closest_s << " s";
}

}  // namespace beespace
