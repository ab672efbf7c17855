// The point that is nearest to a preferred one within the intersection of half-spaces and a ball.
//
// A convex program in three unknowns, solved one half-space after the other: where the best point
// so far is outside the next half-space, the best one lies on its plane. There the same problem has
// two unknowns, and on a line one. Expected to be linear in the number of half-spaces if they come
// in random order.
#pragma once

#include "base/vector3.hpp"

#include <optional>
#include <span>

namespace beespace::avoidance {

using core::Vector3;

// normal * x >= offset; the normal has length 1.
struct HalfSpace {
  Vector3 normal;
  double offset = 0.0;

  [[nodiscard]] double inside_by(const Vector3& x) const { return dot(normal, x) - offset; }
};

struct Ball {
  Vector3 center;
  double radius = 0.0;
};

// Nothing where the intersection is empty, or lost in rounding.
std::optional<Vector3> nearest_place(const Vector3& target, std::span<const HalfSpace> half_spaces,
                                     const Ball& ball);

}  // namespace beespace::avoidance
