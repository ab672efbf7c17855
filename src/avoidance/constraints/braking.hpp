// The stopping segment of a bee.
//
// With acceleration A and steps of dt, a bee at speed u that is told to brake stops within s(u) =
// u^2 / 2A + u dt / 2, straight on: the second term is the step in which braking begins. A step
// later it needs s less the distance flown. So a bee that can stop within its segment now can
// always do so. A bee without a limit of acceleration stops where it is.
#pragma once

#include "base/vector3.hpp"

#include <beespace/advise.hpp>

#include <algorithm>
#include <cmath>

namespace beespace::avoidance {

using core::Vector3;

class Braking {
 public:
  Braking() = default;  // of no agent yet
  Braking(const FlightLimits& limits, double step_s)
      : at_once_(std::isinf(limits.max_acceleration_mps2)),
        per_acceleration_(at_once_ ? 0.0 : 1.0 / limits.max_acceleration_mps2),
        change_(limits.max_acceleration_mps2 * step_s),
        step_s_(step_s) {}

  // Whether velocities change at once.
  [[nodiscard]] bool at_once() const { return at_once_; }
  // The greatest change of velocity in a step.
  [[nodiscard]] double change() const { return change_; }

  [[nodiscard]] double step_s() const { return step_s_; }

  // From the bee's position to its latest stopping point.
  [[nodiscard]] Vector3 stopping_segment(const Vector3& velocity) const {
    if (at_once_) return {};
    return velocity * (0.5 * (length(velocity) * per_acceleration_ + step_s_));
  }

  // A step that ends with a new velocity, and the stop after it, lead from the bee's position by
  // drift(old) + way_after(new).
  [[nodiscard]] Vector3 drift(const Vector3& old) const {
    return at_once_ ? Vector3{} : old * (0.5 * step_s_);
  }
  [[nodiscard]] Vector3 way_after(const Vector3& velocity) const {
    return velocity * (step_s_ + 0.5 * length(velocity) * per_acceleration_);
  }
  // The slopes of way_after in the speed u, across the velocity and along it.
  [[nodiscard]] double growth_across(double speed) const {
    return step_s_ + 0.5 * speed * per_acceleration_;
  }
  [[nodiscard]] double growth_along(double speed) const {
    return step_s_ + speed * per_acceleration_;
  }

  // How far from the end of its stopping segment a step and the stop after it may take the bee: the
  // distance flown in a step at its speed, plus what a change of the velocity moves the stop.
  [[nodiscard]] double strays(const Vector3& velocity, double max_speed) const {
    if (at_once_) return max_speed * step_s_;
    const double speed = length(velocity);
    return speed * step_s_ + change_ * growth_along(speed + change_);
  }

  // The velocity at the end of a step of full braking.
  [[nodiscard]] Vector3 braked(const Vector3& velocity) const {
    const double speed = length(velocity);
    return speed > change_ ? velocity * ((speed - change_) / speed) : Vector3{};
  }

 private:
  bool at_once_ = true;
  double per_acceleration_ = 0.0;  // 1 / A
  double change_ = 0.0;            // A dt
  double step_s_ = 0.0;
};

}  // namespace beespace::avoidance
