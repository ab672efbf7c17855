#include "io/recording/rough_distance.hpp"

#include <cmath>
#include <numbers>

namespace beespace::io {
namespace {

double length(double x, double y, double z) {
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace

double rough_distance_m(const Point& a, const Point& b, Frame frame) {
  constexpr double kRadians = std::numbers::pi / 180.0;
  constexpr double kMetresPerDegree = 111'195.0;
  if (frame != Frame::kWgs84) return length(a.x - b.x, a.y - b.y, a.z - b.z);
  const double east = std::remainder(a.x - b.x, 360.0) * std::cos((a.y + b.y) / 2.0 * kRadians);
  return length(kMetresPerDegree * east, kMetresPerDegree * (a.y - b.y), a.z - b.z);
}

}  // namespace beespace::io
