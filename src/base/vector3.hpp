// Arithmetic with places, ways and velocities.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cmath>

namespace beespace::core {

struct Vector3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator-(const Vector3& a) {
  return {-a.x, -a.y, -a.z};
}
inline Vector3 operator*(const Vector3& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline double dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vector3& a) {
  return std::sqrt(dot(a, a));
}

inline Vector3 vector_of(const Point& p) {
  return {p.x, p.y, p.z};
}
inline Vector3 vector_of(const Velocity& v) {
  return {v.x, v.y, v.z};
}

// As it is, or shortened to the length.
inline Vector3 at_most(const Vector3& a, double longest) {
  const double squared = dot(a, a);
  return squared > longest * longest ? a * (longest / std::sqrt(squared)) : a;
}

}  // namespace beespace::core
