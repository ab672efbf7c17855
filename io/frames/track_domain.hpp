// What positions, times and velocities of recordings may be: zero, or of a magnitude that motion
// can be computed with exactly (see mover.hpp).
#pragma once

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cmath>
#include <string_view>

namespace beespace::io {

inline bool in_motion_domain(double value) {
  const double magnitude = std::abs(value);
  return magnitude == 0.0 || (magnitude >= kSmallestInMotion && magnitude <= kLargestInMotion);
}

// What is smaller counts as zero where it enters, as in the library: a velocity that fades away, or
// a coordinate that should be zero, never makes a record a bad one. Less than 8e-31 of a metre, or
// of a metre per second, is nothing.
inline double without_dust(double value) {
  return std::abs(value) < kSmallestInMotion ? 0.0 : value;
}
inline Point without_dust(const Point& point) {
  return {without_dust(point.x), without_dust(point.y), without_dust(point.z)};
}

// For messages.
inline constexpr std::string_view kMotionDomain = "7.9e-31 to 1.3e+30";

}  // namespace beespace::io
