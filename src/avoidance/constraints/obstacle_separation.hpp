// The constraint of an obstacle on a bee: a half-space with all of a convex piece on the other
// side, which must contain the bee's path in the next step and its stop after it.
#pragma once

#include "avoidance/constraints/closest_points.hpp"
#include "avoidance/constraints/half_spaces.hpp"
#include "obstacles/convex_piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beespace::avoidance {

// As SeparatingPlane, between a stopping segment and a piece that does not move.
struct ObstacleSeparation {
  Vector3 normal;  // towards the way
  double gap;      // between what the two reach along it
  double edge;     // what the piece reaches along it

  [[nodiscard]] HalfSpace of_way(double apart) const {
    return {normal, edge + std::min(apart, gap)};
  }
};

// The point of a segment that is closest to a convex piece: the distance along the segment is
// convex, so its slope changes sign once.
inline Vector3 closest_on_way(const Segment& way, const obstacles::ConvexPiece& piece) {
  const auto slope = [&](double share) {
    const obstacles::Facing facing = piece.facing(way.at(share));
    return facing.surface.distance_m > 0.0 ? dot(facing.normal, way.way) : 0.0;
  };
  if (!(slope(0.0) < 0.0)) return way.from;
  if (slope(1.0) <= 0.0) return way.at(1.0);
  constexpr int kHalvings = 50;
  double low = 0.0;
  double high = 1.0;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (slope(middle) < 0.0 ? low : high) = middle;
  }
  return way.at(0.5 * (low + high));
}

// For a segment that begins in an obstacle: straight out to its nearest surface.
inline ObstacleSeparation part_inside(const Segment& way, const obstacles::Facing& out) {
  const Vector3& normal = out.normal;
  const double edge = dot(normal, core::vector_of(out.surface.point));
  return {normal, std::min(dot(normal, way.from), dot(normal, way.at(1.0))) - edge, edge};
}

// The widest gap between a segment and a convex piece of an obstacle, or one that is wide enough.
// Any normal is valid, as in SeparatingPlane.
class ObstacleSeparationSearch {
 public:
  ObstacleSeparationSearch(const Segment& way, const obstacles::ConvexPiece& piece)
      : way_(way), piece_(piece) {}

  ObstacleSeparation operator()(double enough) {
    const obstacles::Facing closest = piece_.facing(closest_on_way(way_, piece_));
    consider(closest.normal);
    if (best_.gap >= enough) return best_;
    // A segment that enters the piece is turned back where it enters.
    if (closest.surface.distance_m > 0.0) consider_across(closest.normal);
    return best_;
  }

 private:
  void consider(const Vector3& out) {
    const double far = length(out);
    if (!(far > 0.0)) return;
    const Vector3 normal = out * (1.0 / far);
    const double edge = piece_.support(normal);
    const double gap = std::min(dot(normal, way_.from), dot(normal, way_.at(1.0))) - edge;
    if (!std::isfinite(gap) || gap <= best_.gap) return;
    best_ = {normal, gap, edge};
  }

  // With a long segment and a long edge, a normal that is tilted a little loses much. The widest
  // gap is at right angles to the segment, and to the edge where it is closest to one: upright, or
  // level and at right angles to the direction straight out.
  void consider_across(const Vector3& out) {
    const double squared = dot(way_.way, way_.way);
    if (!(squared > 0.0)) return;
    consider(out - way_.way * (dot(out, way_.way) / squared));
    for (const Vector3& edge : {Vector3{0.0, 0.0, 1.0}, Vector3{-out.y, out.x, 0.0}}) {
      const Vector3 across = cross(way_.way, edge);
      consider(dot(across, out) < 0.0 ? -across : across);
    }
  }

  const Segment& way_;
  const obstacles::ConvexPiece& piece_;
  ObstacleSeparation best_{{0.0, 0.0, 1.0}, -std::numeric_limits<double>::infinity(), 0.0};
};

inline ObstacleSeparation separate(const Segment& way, const obstacles::ConvexPiece& piece,
                                   double enough = std::numeric_limits<double>::infinity()) {
  return ObstacleSeparationSearch(way, piece)(enough);
}

}  // namespace beespace::avoidance
