// The constraint of two bees on each other: half-spaces that must contain their paths in the next
// step and their stops after it.
//
// The present stopping segments lie on either side of a gap. Each bee keeps to its own side, half
// of the threshold away from the middle. Whatever both do within their half-spaces, they stay the
// threshold apart, or their present distance where that is less. The proof is in
// docs/prevention.md.
#pragma once

#include "avoidance/constraints/closest_points.hpp"
#include "avoidance/constraints/half_spaces.hpp"
#include "avoidance/constraints/sideways.hpp"

#include <algorithm>
#include <limits>

namespace beespace::avoidance {

// The gap between two stopping segments.
struct SeparatingPlane {
  Vector3 normal;  // from the second towards the first
  double gap;      // between what the two reach along it; below zero where they overlap
  double middle;   // of the gap, along the normal

  // The half-spaces of the first and the second that keep them so far apart, or at their present
  // distance. The free distance between them is halved; with `lean` 1 all of it is the second's,
  // with -1 all of it is the first's.
  [[nodiscard]] HalfSpace of_first(double apart, double lean) const {
    return {normal, middle + 0.5 * (std::min(apart, gap) + lean * free(apart))};
  }
  [[nodiscard]] HalfSpace of_second(double apart, double lean) const {
    return {-normal, -middle + 0.5 * (std::min(apart, gap) - lean * free(apart))};
  }
  [[nodiscard]] double free(double apart) const { return std::max(0.0, gap - apart); }
};

// The widest gap, or one that is wide enough. Any normal is valid: the gap is computed from the
// extents of both along it, whatever was rounded before, and is never wider than their distance.
// The first of the two is that of the lower id, so that both get the same plane.
class SeparatingPlaneSearch {
 public:
  SeparatingPlaneSearch(const Segment& first, const Segment& second)
      : first_(first), second_(second) {}

  SeparatingPlane operator()(double enough) {
    consider(closest_points(first_, second_).between());
    if (found_ && best_.gap >= enough) return best_;
    // With segments that are long and almost parallel, a normal that is tilted a little loses much.
    // The widest gap is at right angles to both, or from an end of one to the other.
    const Vector3 normal = across_both(cross(first_.way, second_.way));
    consider(normal);
    consider(-normal);
    for (const double end : {0.0, 1.0}) {
      consider_both(first_.at(end) - second_.closest_to(first_.at(end)), second_.way);
      consider_both(first_.closest_to(second_.at(end)) - second_.at(end), first_.way);
    }
    // Two that fly straight at each other, and can stop no more, turn to their right.
    if (!(found_ && best_.gap > 0.0)) {
      for (const Vector3& way : {first_.way, second_.way}) {
        if (!(dot(way, way) > 0.0)) continue;
        consider(right_of(way));
        consider(-right_of(way));
      }
    }
    // Bees at one place separate in any direction.
    if (!found_) consider(first_.from - second_.from);
    if (!found_) consider({1.0, 0.0, 0.0});
    return best_;
  }

 private:
  void consider(const Vector3& between) {
    const double apart = length(between);
    if (!(apart > 0.0)) return;
    const Vector3 normal = between * (1.0 / apart);
    const double low = std::min(dot(normal, first_.from), dot(normal, first_.at(1.0)));
    const double high = std::max(dot(normal, second_.from), dot(normal, second_.at(1.0)));
    if (found_ && low - high <= best_.gap) return;
    found_ = true;
    best_ = {normal, low - high, 0.5 * (low + high)};
  }

  // At right angles to both segments, however nearly parallel they are: to one, and to the
  // component of the other across it; twice, as the first time rounds.
  [[nodiscard]] Vector3 across_both(Vector3 normal) const {
    const Vector3 along = unit(first_.way);
    Vector3 beside = second_.way;
    for (int k = 0; k < 2; ++k) beside = beside - along * dot(beside, along);
    beside = unit(beside);
    normal = unit(normal);
    for (int k = 0; k < 2; ++k) {
      normal = normal - along * dot(normal, along);
      normal = normal - beside * dot(normal, beside);
    }
    return normal;
  }
  static Vector3 unit(const Vector3& a) {
    const double long_m = length(a);
    return long_m > 0.0 ? a * (1.0 / long_m) : Vector3{};
  }

  // Considers `between`, and its component at right angles to a segment; twice, as the first time
  // rounds.
  void consider_both(const Vector3& between, const Vector3& way) {
    consider(between);
    const double squared = dot(way, way);
    if (!(squared > 0.0)) return;
    const Vector3 across = between - way * (dot(between, way) / squared);
    consider(across - way * (dot(across, way) / squared));
  }

  const Segment& first_;
  const Segment& second_;
  SeparatingPlane best_{};
  bool found_ = false;
};

inline SeparatingPlane separate(const Segment& first, const Segment& second,
                                double enough = std::numeric_limits<double>::infinity()) {
  return SeparatingPlaneSearch(first, second)(enough);
}

}  // namespace beespace::avoidance
