// Three doubles: places, velocities and directions of the truth.
#pragma once

#include "scenes/random_stream.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cmath>

namespace beespace::sim {

struct Vector3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  Vector3& operator+=(const Vector3& b) {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }

  friend Vector3 operator+(Vector3 a, const Vector3& b) { return a += b; }
  friend Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Vector3 operator*(const Vector3& a, double factor) {
    return {a.x * factor, a.y * factor, a.z * factor};
  }
  friend bool operator==(const Vector3&, const Vector3&) = default;
};

inline double length_of(const Vector3& a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

// The same direction, no longer than that.
inline Vector3 shortened(const Vector3& a, double most) {
  const double length = length_of(a);
  return length > most ? a * (most / length) : a;
}

inline Vector3 vector_of(const Point& p) {
  return {p.x, p.y, p.z};
}
inline Vector3 vector_of(const Velocity& v) {
  return {v.x, v.y, v.z};
}
inline Point point_of(const Vector3& a) {
  return {a.x, a.y, a.z};
}
inline Velocity velocity_of(const Vector3& a) {
  return {a.x, a.y, a.z};
}

// In the unit ball, or in the horizontal unit disc.
inline Vector3 uniform_in_ball(scenes::RandomStream& random, bool planar) {
  for (;;) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    const double z = planar ? 0.0 : random.uniform(-1.0, 1.0);
    const Vector3 at{x, y, z};
    if (length_of(at) <= 1.0) return at;
  }
}

// Of length 1.
inline Vector3 uniform_direction(scenes::RandomStream& random, bool planar) {
  for (;;) {
    const Vector3 at = uniform_in_ball(random, planar);
    const double length = length_of(at);
    if (length > 1e-3) return at * (1.0 / length);
  }
}

}  // namespace beespace::sim
