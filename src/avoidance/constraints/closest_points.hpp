// The closest points of two segments.
#pragma once

#include "base/vector3.hpp"

#include <algorithm>

namespace beespace::avoidance {

using core::Vector3;

// The segment from `from` to `from` + `way`.
struct Segment {
  Vector3 from;
  Vector3 way;

  [[nodiscard]] Vector3 at(double share) const { return from + way * share; }
  [[nodiscard]] Vector3 closest_to(const Vector3& point) const {
    const double squared = dot(way, way);
    return squared > 0.0 ? at(std::clamp(dot(point - from, way) / squared, 0.0, 1.0)) : from;
  }
};

struct ClosestPoints {
  Vector3 first;
  Vector3 second;

  [[nodiscard]] Vector3 between() const { return first - second; }
};

namespace detail {

// For segments that are almost parallel, an end of one of them is as good as any point.
inline ClosestPoints closest_of_ends(const Segment& first, const Segment& second) {
  ClosestPoints best{first.closest_to(second.from), second.from};
  const auto improve = [&](const Vector3& a, const Vector3& b) {
    const ClosestPoints other{a, b};
    if (dot(other.between(), other.between()) < dot(best.between(), best.between())) best = other;
  };
  improve(first.closest_to(second.at(1.0)), second.at(1.0));
  improve(first.from, second.closest_to(first.from));
  improve(first.at(1.0), second.closest_to(first.at(1.0)));
  return best;
}

}  // namespace detail

// A point of each, at their least distance; for segments that are almost parallel, nearly so. Both
// lie on their segments to within a few roundings.
inline ClosestPoints closest_points(const Segment& first, const Segment& second) {
  const double a = dot(first.way, first.way);
  const double e = dot(second.way, second.way);
  const double b = dot(first.way, second.way);
  // Below this the point on a line has a larger error than the one from treating both as parallel.
  constexpr double kParallel = 1e-10;
  const double parallel = a * e - b * b;
  if (!(parallel > kParallel * a * e)) return detail::closest_of_ends(first, second);
  const Vector3 r = first.from - second.from;
  const double share =
      std::clamp((b * dot(second.way, r) - dot(first.way, r) * e) / parallel, 0.0, 1.0);
  const Vector3 on_second = second.closest_to(first.at(share));
  return {first.closest_to(on_second), on_second};
}

}  // namespace beespace::avoidance
