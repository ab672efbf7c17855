// Intruders that fly straight on, whatever the bees do.
#pragma once

#include "tests/verify/curve_oracle.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace beespace::test {

inline Point moved(const Point& p, const Velocity& v, double by) {
  return {p.x + v.x * by, p.y + v.y * by, p.z + v.z * by};
}

inline void fly_on(std::vector<Mover>& intruders, double step_s) {
  for (Mover& intruder : intruders) {
    intruder.position = moved(intruder.position, intruder.velocity, step_s);
  }
}

// The closest that a bee comes in a step to an intruder that flies straight on; its velocity
// changes evenly, or at once.
inline double closest_in_step(Mover from, const Mover& to, const Mover& intruder, bool at_once,
                              double step_s) {
  if (at_once) from.velocity = to.velocity;
  const Mover later{moved(intruder.position, intruder.velocity, step_s), intruder.velocity};
  // The minimum of a smooth distance, so a few samples find its neighbourhood.
  const auto distance = [&](long double u) {
    const auto a = place_at(from, to, step_s, u);
    const auto b = place_at(intruder, later, step_s, u);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  return static_cast<double>(least_of(distance, 4));
}

// Where a bee is after a step that ends with this velocity.
inline Mover after_step(const Mover& bee, const Velocity& advised, bool at_once, double step_s) {
  const Velocity first = at_once ? advised : bee.velocity;
  return {moved(moved(bee.position, first, 0.5 * step_s), advised, 0.5 * step_s), advised};
}

// The closest that a bee that does as advised comes to an intruder, in the step and after it.
inline double closest_as_advised(const Mover& bee, const Velocity& advised, const Mover& intruder,
                                 bool at_once, double step_s, double horizon_s) {
  const Mover to = after_step(bee, advised, at_once, step_s);
  double closest_m = closest_in_step(bee, to, intruder, at_once, step_s);
  if (horizon_s > step_s) {
    const double rest_s = horizon_s - step_s;
    const Mover end{moved(to.position, advised, rest_s), advised};
    const Mover met{moved(intruder.position, intruder.velocity, step_s), intruder.velocity};
    closest_m = std::min(closest_m, closest_in_step(to, end, met, false, rest_s));
  }
  return closest_m;
}

}  // namespace beespace::test
