#include "report/placement.hpp"

#include <cmath>
#include <numbers>

namespace beespace::report {

// Sines and cosines of whole quarters have no rounding in them.
PlacementAxes::PlacementAxes(const Placement& placement)
    : side_(placement.y_to_the_right ? 1.0 : -1.0), up_m_(placement.origin.height_m) {
  const double degrees = std::remainder(placement.heading_deg, 360.0);
  const double quarters = degrees / 90.0;
  if (quarters == std::round(quarters)) {
    const int quarter = (static_cast<int>(quarters) + 4) % 4;
    sine_ = quarter == 1 ? 1.0 : quarter == 3 ? -1.0 : 0.0;
    cosine_ = quarter == 0 ? 1.0 : quarter == 2 ? -1.0 : 0.0;
  } else {
    sine_ = std::sin(degrees * std::numbers::pi / 180.0);
    cosine_ = std::cos(degrees * std::numbers::pi / 180.0);
  }
}

// x points along the heading, y a quarter to its left, or to its right.
Point PlacementAxes::operator()(const Point& p) const {
  return {p.x * sine_ + side_ * p.y * cosine_, p.x * cosine_ - side_ * p.y * sine_, height_of(p.z)};
}

}  // namespace beespace::report
