#include "avoidance/disposal.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace beespace::avoidance {

namespace {

// The way in the step lies between the start, half the old velocity on, and the stop after the new
// one: within the half-spaces if the stop is, as the first two lie on the old way to a stop.
bool keeps_to(const Flyer& flyer, const Vector3& velocity, std::span<const HalfSpace> keep_to) {
  const Vector3 stop = flyer.stop_after(velocity);
  return std::all_of(keep_to.begin(), keep_to.end(),
                     [&](const HalfSpace& side) { return side.inside_by(stop) >= 0.0; });
}

// A wish, turned to the right as seen from above: by the angle of this sine.
Vector3 turned_right(const Vector3& wish, double sine) {
  const double speed = length(wish);
  const double level = std::hypot(wish.x, wish.y);
  const Vector3 right = level > 1e-6 * speed
                            ? Vector3{wish.y, -wish.x, 0.0} * (speed / level)
                            : Vector3{speed, 0.0, 0.0};  // straight up or down: any side will do
  return wish * std::sqrt(1.0 - sine * sine) + right * sine;
}

}  // namespace

Vector3 Flyer::able(const Vector3& wish) const {
  const Vector3 slow = at_most(wish, max_speed);
  if (braking.at_once()) return slow;
  // Towards it, as far as the acceleration goes. Who is too fast slows down first.
  const Vector3 next = velocity + at_most(slow - velocity, braking.change());
  return length(velocity) > max_speed ? braking.braked(velocity) : at_most(next, max_speed);
}

Disposal::Disposed Disposal::dispose(const Flyer& flyer, const Vector3& wish,
                                     std::span<const HalfSpace> keep_to) {
  const Vector3 proposed = flyer.able(wish);
  if (keeps_to(flyer, proposed, keep_to)) return {proposed, AdviceKind::kAsWished};

  const Braking& braking = flyer.braking;
  const Vector3 brake = braking.at_once() ? Vector3{} : braking.braked(flyer.velocity);
  // The half-spaces as they look to small changes of the velocity: a change across it and one along
  // it move the stop by different lengths.
  const Vector3 from = braking.at_once() ? Vector3{} : flyer.velocity;
  const double speed = length(from);
  const double across = braking.growth_across(speed);
  const double along = braking.growth_along(speed);
  const Vector3 heading = speed > 0.0 ? from * (1.0 / speed) : Vector3{};
  const Vector3 stop = flyer.stop_after(from);
  in_changes_.clear();
  for (const HalfSpace& side : keep_to) {
    const Vector3& n = side.normal;
    const Vector3 slope = n * across + heading * (dot(n, heading) * (along - across));
    const double steep = length(slope);
    in_changes_.push_back({slope * (1.0 / steep), -side.inside_by(stop) / steep});
  }
  const Ball changes{{}, braking.at_once() ? flyer.max_speed : braking.change()};
  const auto nearest = [&](const Vector3& velocity) {
    const auto found = nearest_place(velocity - from, in_changes_, changes);
    return found ? flyer.able(from + *found) : velocity;
  };
  Vector3 best = nearest(proposed);
  // Whoever gets too little of its way by going straight turns right, the more the less it gets: so
  // that two who meet pass each other, and many who meet go round.
  constexpr double kEnough = 0.6;
  const double progress = std::max(0.0, dot(best, wish) / dot(wish, wish));
  if (progress < kEnough) {
    best = nearest(flyer.able(turned_right(wish, 1.0 - progress / kEnough)));
  }
  // What is left of the curve that was taken for straight: a little towards braking.
  for (const double share : {1.0, 0.999, 0.99, 0.9, 0.7, 0.4, 0.15, 0.05}) {
    const Vector3 velocity = brake + (best - brake) * share;
    if (keeps_to(flyer, velocity, keep_to)) return {velocity, AdviceKind::kDeflected};
  }
  return {brake, AdviceKind::kBraking};
}

}  // namespace beespace::avoidance
