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

constexpr std::size_t kFewestSteps = 20;  // of fewer ones nothing is usual

// Of all steps of a track, or as many as tell it.
double usual_speed_mps(const std::vector<Fix>& fixes, Frame frame) {
  constexpr std::size_t kEnough = 1'000;
  if (fixes.size() <= kFewestSteps) return Jumps::kMostSpeed_mps;
  const std::size_t every = 1 + (fixes.size() - 2) / kEnough;
  NearlyAll speeds_mps;
  for (std::size_t i = 1; i < fixes.size(); i += every) {
    const double seconds = fixes[i].time_s - fixes[i - 1].time_s;
    if (!(seconds > 0.0)) continue;
    speeds_mps.take(flat_distance_m(fixes[i - 1].position, fixes[i].position, frame) / seconds);
  }
  return speeds_mps.least_bound();
}

}  // namespace

Jumps::Jumps(const std::vector<Fix>& fixes, const std::vector<Velocity>& velocities, Frame frame)
    : usual_mps_(usual_speed_mps(fixes, frame)), is_whole_(true) {
  for (std::size_t i = 1; i < velocities.size(); ++i) {
    own_.take(fixes[i - 1], &velocities[i - 1], fixes[i], &velocities[i], frame);
  }
}

bool Jumps::take(const Fix& fix, const Velocity* velocity, Frame frame) {
  const bool jumps = jumps_to(fix, velocity, frame);
  if (!is_whole_ && last_ && velocity_) own_.take(*last_, &*velocity_, fix, velocity, frame);
  if (!is_whole_ && !jumps && last_ && fix.time_s > last_->time_s) {
    const double way_m = flat_distance_m(last_->position, fix.position, frame);
    usual_mps_ = std::max(usual_mps_, way_m / (fix.time_s - last_->time_s));
    ++steps_;
  }
  last_ = fix;
  velocity_ = velocity == nullptr ? std::nullopt : std::optional(*velocity);
  return jumps;
}

double Jumps::most_speed_mps(const Velocity* before, const Velocity* now) const {
  const auto own_before_mps = own_speed(before);
  const auto own_mps = own_speed(now);
  const bool tells = own_before_mps && own_mps;
  if (!tells && !is_whole_ && steps_ < kFewestSteps) return kMostSpeed_mps;
  const double fastest_mps = tells ? std::max(*own_before_mps, *own_mps) : usual_mps_;
  return std::min(kMostSpeed_mps, kTimesOwnSpeed * fastest_mps + kBesideOwnSpeed_mps);
}

bool Jumps::jumps_to(const Fix& fix, const Velocity* velocity, Frame frame) const {
  if (!last_ || !(fix.time_s > last_->time_s)) return false;
  if (is_in_space(last_->position, frame) && is_in_space(fix.position, frame)) return false;
  const Velocity* const before = velocity_ ? &*velocity_ : nullptr;
  const double lasts_s = fix.time_s - last_->time_s;
  if (flat_distance_m(last_->position, fix.position, frame) >
      most_speed_mps(before, velocity) * (lasts_s + kTimesDiffer_s)) {
    return true;
  }
  if (own_.contradicted_by(*last_, before, fix, velocity, frame)) return true;
  return frame == Frame::kWgs84 && (contradicts_stated_climb(*last_, before, fix, velocity) ||
                                    contradicts_stated_speed(*last_, before, fix, velocity));
}

}  // namespace beespace::io
