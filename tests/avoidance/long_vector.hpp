// Vector arithmetic in long doubles, for reference answers.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <algorithm>
#include <cmath>

namespace beespace::test {

struct LongVector {
  long double x = 0.0L;
  long double y = 0.0L;
  long double z = 0.0L;
};

inline LongVector operator+(const LongVector& a, const LongVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline LongVector operator-(const LongVector& a, const LongVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline LongVector operator*(const LongVector& a, long double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline long double dot(const LongVector& a, const LongVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline LongVector cross(const LongVector& a, const LongVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline long double length(const LongVector& a) {
  return std::sqrt(dot(a, a));
}

// Points, velocities, and other types with x, y and z.
template <class Vector>
LongVector long_of(const Vector& v) {
  return {v.x, v.y, v.z};
}

// From `from` along `way`.
struct LongSegment {
  LongVector from;
  LongVector way;

  [[nodiscard]] long double distance_to(const LongVector& point) const {
    const long double squared = dot(way, way);
    const long double share =
        squared > 0.0L ? std::clamp(dot(point - from, way) / squared, 0.0L, 1.0L) : 0.0L;
    return length(point - (from + way * share));
  }
};

// The closest points of two segments are an end of one and a point of the other, or both inside;
// then their difference is at right angles to both.
inline long double distance_between(const LongSegment& a, const LongSegment& b) {
  long double least = std::min({b.distance_to(a.from), b.distance_to(a.from + a.way),
                                a.distance_to(b.from), a.distance_to(b.from + b.way)});
  const LongVector normal = cross(a.way, b.way);
  const long double squared = dot(normal, normal);
  if (!(squared > 0.0L)) return least;
  const LongVector r = b.from - a.from;
  const long double on_a = dot(cross(r, b.way), normal) / squared;
  const long double on_b = dot(cross(r, a.way), normal) / squared;
  if (on_a < 0.0L || on_a > 1.0L || on_b < 0.0L || on_b > 1.0L) return least;
  return std::min(least, length((a.from + a.way * on_a) - (b.from + b.way * on_b)));
}

}  // namespace beespace::test
