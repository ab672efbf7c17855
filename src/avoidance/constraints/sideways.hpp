// The direction to the right, in which all agents give way.
#pragma once

#include "base/vector3.hpp"

#include <cmath>

namespace beespace::avoidance {

// At right angles to a direction, level, of length 1; for one that is almost upright, any.
inline core::Vector3 right_of(const core::Vector3& direction) {
  const double level = std::hypot(direction.x, direction.y);
  if (!(level > 1e-6 * length(direction))) return {1.0, 0.0, 0.0};
  return core::Vector3{direction.y, -direction.x, 0.0} * (1.0 / level);
}

}  // namespace beespace::avoidance
