// The separation to keep, and its result for two bees that move in straight lines: the exact
// decision, and the times and distances of the report.
#pragma once

#include "motion/relative_motion.hpp"

#include <beespace/closest_approach.hpp>
#include <beespace/mover.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace beespace::motion {

// Position and velocity of a bee on x, y, z, and on a fourth axis where heights are kept apart from
// positions (see MoversView); 0 there otherwise.
using Axes4 = std::array<double, 4>;

struct State {
  Axes4 position;
  Axes4 velocity;
};

inline State state_of(const Mover& mover) {
  const auto& [p, v] = mover;
  return {{p.x, p.y, p.z, 0.0}, {v.x, v.y, v.z, 0.0}};
}
inline State state_of(const MoversView& movers, std::size_t i) {
  State state = state_of(movers[i]);
  if (!movers.has_heights()) return state;
  state.position[3] = movers.heights_m()[i];
  state.velocity[3] = movers.climbs_mps()[i];
  return state;
}

struct Separation {
  double threshold_m;
  std::optional<double> vertical_m = {};
  bool inclusive = false;
  bool heights_apart = false;  // heights are on the fourth axis, not on the third
  // The fourth axis and vertical_m count in units of so many metres: for reported distances.
  double height_unit_m = 1.0;

  [[nodiscard]] std::size_t vertical_axis() const { return heights_apart ? 3 : 2; }
  // Pairs that are farther apart are not in conflict: cylinders lie in spheres. Where heights are
  // apart, of positions.
  [[nodiscard]] double reach_m() const {
    return heights_apart ? threshold_m : std::hypot(threshold_m, vertical_m.value_or(0.0));
  }
};

// Of PredictOptions or ConflictOptions.
template <class Options>
Separation separation_of(const Options& options, bool heights_apart = false) {
  return {options.threshold_m, options.vertical_m, options.inclusive, heights_apart,
          options.height_unit_m};
}

// Whether two bees in constant motion are in conflict at some instant of [0, horizon]: exact.
bool in_conflict(const State& a, const State& b, const Separation& separation, double horizon_s);

RelativeMotion<4> relative_motion(const State& a, const State& b);

// The same with heights converted to metres, rounded: for distances.
RelativeMotion<4> in_metres(RelativeMotion<4> motion, const Separation& separation);

// A conflict of two: from when to when, and the closest approach in between.
struct ConflictReport {
  TimeSpan span;
  double closest_s;
  double closest_m;
};
ConflictReport report_conflict(const RelativeMotion<4>& motion, const Separation& separation,
                               double horizon_s);

}  // namespace beespace::motion
