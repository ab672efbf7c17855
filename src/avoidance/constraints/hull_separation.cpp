#include "avoidance/constraints/hull_separation.hpp"

#include "avoidance/constraints/sideways.hpp"
#include "avoidance/constraints/simplex.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace beespace::avoidance {

namespace {

Vector3 unit(const Vector3& a) {
  const double long_m = length(a);
  return long_m > 0.0 ? a * (1.0 / long_m) : Vector3{};
}

class HullSeparationSearch {
 public:
  HullSeparationSearch(const Hull& first, const Hull& second, const FreeBetween& between,
                       double enough_m)
      : first_(first), second_(second), between_(between), enough_m_(enough_m) {}

  HullSeparation operator()(const Vector3& remembered) {
    consider(remembered);
    const Vector3 start = found_ ? best_.plane.normal : first_.axis.from - second_.axis.from;
    approach_hulls(start);
    if (!between_.shape.is_sphere()) approach_shape();
    if (found_ && best_.left_m() >= enough_m_) return best_;
    consider_special();
    return best_;
  }

 private:
  void consider(const Vector3& towards_first) {
    const Vector3 level{towards_first.x, towards_first.y, between_.planar ? 0.0 : towards_first.z};
    const double far = length(level);
    if (!(far > 0.0)) return;
    const Vector3 normal = level * (1.0 / far);
    const double low = first_.lowest(normal);
    const double high = second_.highest(normal);
    const HullSeparation other{{normal, low - high, 0.5 * (low + high)}, between_.along(normal)};
    if (found_ && other.left_m() <= best_.left_m()) return;
    found_ = true;
    best_ = other;
  }

  // The point of the difference of the hulls that lies lowest along n, of any length.
  [[nodiscard]] Vector3 lowest_difference(const Vector3& n) const {
    return first_.lowest_point(n) - second_.lowest_point(-n);
  }

  // Goes down to the point of a convex set that is closest to the origin, given its lowest point
  // along any direction, and gives the direction of length 1 along which most of the set was seen
  // to lie beyond the origin. Each iteration comes closer, or is the last.
  template <class Lowest>
  Vector3 approach(const Vector3& start, double enough_m, const Lowest& lowest) {
    constexpr int kMost = 48;
    constexpr double kClose = 1e-12;  // of the distance
    constexpr double kWasted = 0.02;  // of what is left beyond enough
    Vector3 best_normal;
    double best = -std::numeric_limits<double>::infinity();
    simplex_.start(lowest(start));
    Vector3 closest = simplex_.closest();
    for (int k = 0; k < kMost; ++k) {
      const double far = length(closest);
      if (!(far > 0.0)) break;
      const Vector3 normal = closest * (1.0 / far);
      const Vector3 corner = lowest(normal);
      const double low = dot(normal, corner);
      if (low > best) best = low, best_normal = normal;
      if (far - best <= std::max(kClose * far, kWasted * (best - enough_m))) break;
      if (!simplex_.add(corner)) break;
      const Vector3 next = simplex_.closest();
      if (simplex_.size() == 4 || !(dot(next, next) < far * far)) break;
      closest = next;
    }
    return best_normal;
  }

  // The closest points of the hulls; where an ellipsoid is to stay free, in a space in which it is
  // a sphere.
  void approach_hulls(const Vector3& start) {
    const double shrink = 1.0 / between_.shape.vertical_factor();
    const auto shrunk = [&](const Vector3& a) { return Vector3{a.x, a.y, a.z * shrink}; };
    const double enough_m = between_.horizontal_m + between_.beyond_m + enough_m_;
    consider(shrunk(approach(
        start, enough_m, [&](const Vector3& n) { return shrunk(lowest_difference(shrunk(n))); })));
  }

  // The closest points where the shape is added to the hulls. Where it meets them, there is none.
  void approach_shape() {
    if (!found_) return;
    consider(approach(best_.plane.normal, between_.beyond_m + enough_m_, [&](const Vector3& n) {
      return lowest_difference(n) - between_.shape.farthest(between_.horizontal_m, unit(n));
    }));
  }

  // For claims that are long and thin, or touch, or overlap.
  void consider_special() {
    consider_across(simplex_.corners());
    const SeparatingPlane axes = separate(first_.axis, second_.axis);
    consider(axes.normal);
    if (!between_.shape.is_sphere()) {
      consider({axes.normal.x, axes.normal.y, 0.0});
      consider({0.0, 0.0, 1.0});
      consider({0.0, 0.0, -1.0});
    }
    // Two that fly straight at each other, and can stop no more, turn to their right.
    if (!(found_ && best_.plane.gap > 0.0)) {
      for (const Vector3& way : {first_.axis.way, second_.axis.way}) {
        if (!(dot(way, way) > 0.0)) continue;
        consider(right_of(way));
        consider(-right_of(way));
      }
    }
    if (!found_) consider({1.0, 0.0, 0.0});
  }

  // The best normal, exactly at right angles to the edges that the closest points lie on.
  void consider_across(std::span<const Vector3> corners) {
    if (!found_ || corners.size() < 2) return;
    const Vector3 along = unit(corners[1] - corners[0]);
    Vector3 beside = corners.size() == 3 ? corners[2] - corners[0] : Vector3{};
    for (int k = 0; k < 2; ++k) beside = beside - along * dot(beside, along);
    beside = unit(beside);
    Vector3 normal = best_.plane.normal;
    for (int k = 0; k < 2; ++k) {
      normal = normal - along * dot(normal, along);
      normal = normal - beside * dot(normal, beside);
    }
    consider(normal);
  }

  const Hull& first_;
  const Hull& second_;
  const FreeBetween& between_;
  double enough_m_;
  Simplex simplex_;
  HullSeparation best_{};
  bool found_ = false;
};

}  // namespace

double Hull::lowest(const Vector3& n) const {
  double low = dot(n, points[0]);
  for (const Vector3& point : points.subspan(1)) low = std::min(low, dot(n, point));
  return low;
}

double Hull::highest(const Vector3& n) const {
  double high = dot(n, points[0]);
  for (const Vector3& point : points.subspan(1)) high = std::max(high, dot(n, point));
  return high;
}

const Vector3& Hull::lowest_point(const Vector3& n) const {
  std::size_t best = 0;
  double low = dot(n, points[0]);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const double along = dot(n, points[k]);
    if (along < low) low = along, best = k;
  }
  return points[best];
}

HullSeparation separate(const Hull& first, const Hull& second, const FreeBetween& between,
                        const Vector3& remembered, double enough_m) {
  return HullSeparationSearch(first, second, between, enough_m)(remembered);
}

}  // namespace beespace::avoidance
