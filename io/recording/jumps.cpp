#include "io/recording/jumps.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::io {
namespace {

// Satellites are faster: above kSpace_m, or as far from the middle of the Earth.
bool is_in_space(const Point& at, Frame frame) {
  constexpr double kSpace_m = 80'000.0;
  constexpr double kEarth_m = 6'356'000.0;
  if (frame == Frame::kWgs84) return at.z > kSpace_m;
  return std::hypot(at.x, at.y, at.z) > kEarth_m + kSpace_m;
}

// Nothing where it is not told, or is 0, which may mean the same.
std::optional<double> own_speed(const Velocity* velocity) {
  if (velocity == nullptr) return std::nullopt;
  const double climb = std::isnan(velocity->z) ? 0.0 : velocity->z;
  const double speed_mps = std::hypot(velocity->x, velocity->y, climb);
  return speed_mps > 0.0 ? std::optional(speed_mps) : std::nullopt;
}

}  // namespace

bool Jumps::take(const Fix& fix, const Velocity* velocity, Frame frame) {
  const auto before = std::exchange(last_, fix);
  const auto own_before_mps = std::exchange(own_mps_, own_speed(velocity));
  if (!before || !(fix.time_s > before->time_s)) return false;
  if (is_in_space(before->position, frame) && is_in_space(fix.position, frame)) return false;
  double most_mps = kMostSpeed_mps;
  if (own_before_mps && own_mps_) {
    const double own_mps = std::max(*own_before_mps, *own_mps_);
    most_mps = std::min(most_mps, kTimesOwnSpeed * own_mps + kBesideOwnSpeed_mps);
  }
  return flat_distance_m(before->position, fix.position, frame) >
         most_mps * (fix.time_s - before->time_s + kTimesDiffer_s);
}

}  // namespace beespace::io
