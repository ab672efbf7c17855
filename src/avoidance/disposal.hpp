// What becomes of a proposed velocity: the nearest one that is certified.
//
// Any proposal will do, a good one or a bad one; whatever comes out keeps to the half-spaces,
// except that the bee brakes as hard as it can where nothing better is found. Braking keeps to them
// too.
#pragma once

#include "avoidance/braking.hpp"
#include "avoidance/closest_points.hpp"
#include "avoidance/half_spaces.hpp"

#include <beespace/advise.hpp>

#include <span>
#include <vector>

namespace beespace::avoidance {

// A bee at the beginning of a step.
struct Flyer {
  Vector3 position;
  Vector3 velocity;
  Braking braking;
  double max_speed;

  [[nodiscard]] Segment way_to_stop() const { return {position, braking.way_to_stop(velocity)}; }
  // Where it comes to a stop if it has a velocity at the end of the step.
  [[nodiscard]] Vector3 stop_after(const Vector3& next) const {
    return position + braking.drift(velocity) + braking.way_after(next);
  }
  // The nearest velocity within its limits.
  [[nodiscard]] Vector3 able(const Vector3& wish) const;
  // How far from where it is it may get in the step and the stop after it.
  [[nodiscard]] double reach() const { return braking.reach(velocity, max_speed); }
};

class Disposal {
 public:
  struct Disposed {
    Vector3 velocity;
    AdviceKind kind;
  };
  // `keep_to` are the half-spaces of the bee, in which its way to a stop lies.
  Disposed dispose(const Flyer& flyer, const Vector3& wish, std::span<const HalfSpace> keep_to);

 private:
  std::vector<HalfSpace> in_changes_;  // of velocity
};

}  // namespace beespace::avoidance
