#include "io/points/zero_points.hpp"

#include <cmath>

namespace beespace::io {
namespace {

constexpr double kDegree = 0.0174532925;  // in radians
constexpr double kAtPole_m = 0.001;

bool is_zero(const Point& at) {
  return at.y == 0.0 && at.z == 0.0 && at.x > 0.0;
}

bool is_pole(const Point& at) {
  return at.z < 0.0 && std::abs(at.x) < kAtPole_m && std::abs(at.y) < kAtPole_m;
}

}  // namespace

std::vector<std::size_t> ZeroPoints::look_at(std::span<const Point> ecef) {
  std::vector<std::size_t> zeros;
  for (std::size_t i = 0; i < ecef.size(); ++i) {
    const Point& at = ecef[i];
    if (is_zero(at) || is_pole(at)) {
      zeros.push_back(i);
      continue;
    }
    const double degree_m = kDegree * std::abs(at.x);
    near_zero_ =
        near_zero_ || (at.x > 0.0 && std::abs(at.y) <= degree_m && std::abs(at.z) <= degree_m);
    near_pole_ = near_pole_ || (at.z < 0.0 && std::hypot(at.x, at.y) <= kDegree * -at.z);
  }
  return zeros;
}

bool ZeroPoints::is_none(const Point& ecef) const {
  return is_zero(ecef) ? !near_zero_ : !near_pole_;
}

}  // namespace beespace::io
