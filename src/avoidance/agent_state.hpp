// One agent at the beginning of a step.
#pragma once

#include "avoidance/constraints/braking.hpp"
#include "avoidance/constraints/closest_points.hpp"

namespace beespace::avoidance {

struct AgentState {
  Vector3 position;
  Vector3 velocity;
  Braking braking;
  double max_speed = 0.0;
  bool planar = false;  // its velocities are horizontal

  [[nodiscard]] Segment stopping_segment() const {
    return {position, braking.stopping_segment(velocity)};
  }
  // Where it stops if it has this velocity at the end of the step.
  [[nodiscard]] Vector3 stop_after(const Vector3& next) const {
    return position + braking.drift(velocity) + braking.way_after(next);
  }
  // How far from the end of its stopping segment a step and the stop after it may take it.
  [[nodiscard]] double strays() const { return braking.strays(velocity, max_speed); }

  // The nearest velocity within its limits: towards the preferred velocity, as far as the
  // acceleration goes. An agent that is too fast brakes first.
  [[nodiscard]] Vector3 able(const Vector3& preferred) const {
    const Vector3 slow = at_most(preferred, max_speed);
    if (braking.at_once()) return slow;
    if (length(velocity) > max_speed) return braking.braked(velocity);
    return at_most(velocity + at_most(slow - velocity, braking.change()), max_speed);
  }
};

}  // namespace beespace::avoidance
