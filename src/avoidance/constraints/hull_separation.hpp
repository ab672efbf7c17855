// The plane between two claims, which are convex hulls of a few points, so that the most is left
// beyond what must stay free: an ellipsoid or a cylinder reaches farther in some directions than in
// others.
//
// Any normal is valid: what is left along it is computed from the extents of all points. So the
// search may be inexact, and ends after some iterations in any case.
#pragma once

#include "avoidance/constraints/closest_points.hpp"
#include "avoidance/constraints/free_shape.hpp"
#include "avoidance/constraints/separating_plane.hpp"

#include <span>

namespace beespace::avoidance {

// The points whose convex hull a claim is; and a capsule that contains it: a segment that ends
// where the agent stops, and a distance from it.
struct Hull {
  std::span<const Vector3> points;
  Segment axis;
  double beside_m = 0.0;

  // The least and the greatest n . p of all points p; and the point with the least.
  [[nodiscard]] double lowest(const Vector3& n) const;
  [[nodiscard]] double highest(const Vector3& n) const;
  [[nodiscard]] const Vector3& lowest_point(const Vector3& n) const;
};

// What two claims must leave free between them.
struct FreeBetween {
  FreeShape shape;
  double horizontal_m = 0.0;  // the semi-axis of the shape
  double beyond_m = 0.0;      // in all directions: of tubes
  bool planar = false;        // all normals are horizontal

  [[nodiscard]] double along(const Vector3& normal) const {
    return shape.support(horizontal_m, normal) + beyond_m;
  }
};

struct HullSeparation {
  SeparatingPlane plane;
  double free_m = 0.0;  // what must stay free along its normal

  [[nodiscard]] double left_m() const { return plane.gap - free_m; }
};

// `remembered` is a normal that is considered first; zero for none. Where as much as `enough_m` is
// left the search ends early: little of what is left beyond that may then be lost.
HullSeparation separate(const Hull& first, const Hull& second, const FreeBetween& between,
                        const Vector3& remembered, double enough_m);

}  // namespace beespace::avoidance
