#include "sim/disturbance.hpp"

namespace beespace::sim {

Disturbance::Disturbance(const DisturbanceBounds& bounds, std::uint64_t seed)
    : bounds_(bounds), random_(seed) {
  drift_way_ = uniform_direction(random_, bounds_.planar);
  gust_way_ = uniform_direction(random_, bounds_.planar);
  flips_in_s_ = random_.uniform(0.0, bounds_.most_gust_s);
}

void Disturbance::flip() {
  sign_ = -sign_;
  flips_in_s_ += random_.uniform(bounds_.least_gust_s, bounds_.most_gust_s);
  // Another gust of the same wind comes from elsewhere, now and then.
  if (bounds_.kind == ErrorKind::kUniform && random_.uniform() < 0.25) {
    gust_way_ = uniform_direction(random_, bounds_.planar);
  }
}

void Disturbance::go_on(double lasts_s, const Vector3& towards) {
  flips_in_s_ -= lasts_s;
  while (flips_in_s_ <= 0.0) flip();
  if (bounds_.kind == ErrorKind::kAdversarial && !(towards == Vector3{})) {
    drift_way_ = towards;
    gust_way_ = towards;
  }
  velocity_ = drift_way_ * bounds_.drift_mps + gust_way_ * (sign_ * bounds_.gust_mps);
}

Vector3 Disturbance::error(double bound) {
  if (bounds_.kind == ErrorKind::kUniform) return uniform_in_ball(random_, bounds_.planar) * bound;
  return gust_way_ * (-sign_ * bound);
}

}  // namespace beespace::sim
