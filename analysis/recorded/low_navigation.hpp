// Whether drones of a show move sideways below the height from which it says that they do
// (minNavAltitude of Skybrush Studio).
//
// Paths are sampled, and their places rounded to millimetres or centimetres: who climbs straight up
// seems to move by so much. Speeds do not tell that from moving, as a centimetre within a 24th of a
// second is 0.24 m/s; how far it gets while it is that low does.
#pragma once

#include "analysis/recorded/flights.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace beespace::analysis {

// Up to this far from where it came that low, or stood, a drone does not count as moving sideways.
inline constexpr double kSidewaysAtMost_m = 0.1;

// One that moves, and what is the most of it.
struct LowMove {
  PointId bee = 0;
  double moved_m = 0.0;      // sideways, from where the stretch below that height begins
  double at_s = 0.0;         // when it is so far
  double fastest_mps = 0.0;  // sideways, within that stretch
};

struct NavigationCheck {
  std::string name;
  double height_m = 0.0;
  std::size_t bees = 0;  // that move sideways below it
  std::optional<LowMove> worst = {};

  [[nodiscard]] bool kept() const { return !worst; }
};

// Errors: those of to_track(), without the bee.
Result<NavigationCheck> check_navigation(const std::string& name, double height_m,
                                         const std::vector<Flight>& flights);

// "4 drones move sideways below minNavAltitude 2.5 m, the worst 3.2 m, at up to 0.5 m/s"; without
// the bee and the time.
std::string low_move_text(const NavigationCheck& check);

}  // namespace beespace::analysis
