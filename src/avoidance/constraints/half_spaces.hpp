// The place that is nearest to a wish, among those that all of some half-spaces and a ball have in
// common.
//
// A convex program in three unknowns, solved one half-space after the other: where the best place
// so far is outside the next, the best one lies on its plane; there the same is asked in two
// unknowns, and on a line in one. Expected to be linear in the number of half-spaces if they come
// in no particular order.
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

// Nothing where they have no place in common, or none that rounding leaves.
std::optional<Vector3> nearest_place(const Vector3& wish, std::span<const HalfSpace> half_spaces,
                                     const Ball& ball);

}  // namespace beespace::avoidance
