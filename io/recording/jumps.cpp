#include "io/recording/jumps.hpp"

#include "io/recording/flat_distance.hpp"
#include "io/recording/stated_rates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

Jumps::Jumps(const std::vector<Fix>& fixes, const std::vector<Velocity>& velocities, Frame frame)
    : is_whole_(true) {
  for (std::size_t i = 1; i < velocities.size(); ++i) {
    own_.take(fixes[i - 1], &velocities[i - 1], fixes[i], &velocities[i], frame);
  }
}

bool Jumps::take(const Fix& fix, const Velocity* velocity, Frame frame) {
  const bool jumps = jumps_to(fix, velocity, frame);
  if (!is_whole_ && last_ && velocity_) own_.take(*last_, &*velocity_, fix, velocity, frame);
  last_ = fix;
  velocity_ = velocity == nullptr ? std::nullopt : std::optional(*velocity);
  return jumps;
}

bool Jumps::jumps_to(const Fix& fix, const Velocity* velocity, Frame frame) const {
  if (!last_ || !(fix.time_s > last_->time_s)) return false;
  if (is_in_space(last_->position, frame) && is_in_space(fix.position, frame)) return false;
  const Velocity* const before = velocity_ ? &*velocity_ : nullptr;
  const auto own_before_mps = own_speed(before);
  const auto own_mps = own_speed(velocity);
  double most_mps = kMostSpeed_mps;
  if (own_before_mps && own_mps) {
    const double fastest_mps = std::max(*own_before_mps, *own_mps);
    most_mps = std::min(most_mps, kTimesOwnSpeed * fastest_mps + kBesideOwnSpeed_mps);
  }
  const double lasts_s = fix.time_s - last_->time_s;
  if (flat_distance_m(last_->position, fix.position, frame) >
      most_mps * (lasts_s + kTimesDiffer_s)) {
    return true;
  }
  if (own_.contradicted_by(*last_, before, fix, velocity, frame)) return true;
  return frame == Frame::kWgs84 && (contradicts_stated_climb(*last_, before, fix, velocity) ||
                                    contradicts_stated_speed(*last_, before, fix, velocity));
}

}  // namespace beespace::io
