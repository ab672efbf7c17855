// How far apart two places are horizontally and vertically: what a vertical threshold compares, in
// metres, for those who read it.
#pragma once

#include <beespace/point.hpp>

#include <cmath>

namespace beespace::analysis {

struct Apart {
  double horizontal_m = 0.0;
  double vertical_m = 0.0;
};

// Whose heights are z.
inline Apart apart(const Point& a, const Point& b) {
  return {std::hypot(a.x - b.x, a.y - b.y), std::abs(a.z - b.z)};
}

// Whose heights stand beside them, in a unit of so many metres.
inline Apart apart(const Point& a, double height_a, const Point& b, double height_b,
                   double height_unit_m) {
  return {std::hypot(a.x - b.x, a.y - b.y, a.z - b.z),
          std::abs(height_a - height_b) * height_unit_m};
}

}  // namespace beespace::analysis
