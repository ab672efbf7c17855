// How far apart two places of an input are, about: of degrees as if the Earth were flat there. For
// judgements of which a few parts in a thousand change nothing.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/point.hpp>

#include <cmath>
#include <numbers>

namespace beespace::io {

// How far one is to the east, to the north and above the other, in metres.
inline Point flat_offset_m(const Point& a, const Point& b, Frame frame) {
  constexpr double kRadians = std::numbers::pi / 180.0;
  constexpr double kMetresPerDegree = 111'195.0;
  if (frame != Frame::kWgs84) return {a.x - b.x, a.y - b.y, a.z - b.z};
  const double east = std::remainder(a.x - b.x, 360.0) * std::cos((a.y + b.y) / 2.0 * kRadians);
  return {kMetresPerDegree * east, kMetresPerDegree * (a.y - b.y), a.z - b.z};
}

inline double flat_distance_m(const Point& a, const Point& b, Frame frame) {
  const Point apart = flat_offset_m(a, b, frame);
  return std::sqrt(apart.x * apart.x + apart.y * apart.y + apart.z * apart.z);
}

}  // namespace beespace::io
