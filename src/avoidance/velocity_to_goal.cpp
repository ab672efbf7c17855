#include <beespace/advise.hpp>

#include "avoidance/validate.hpp"
#include "base/vector3.hpp"
#include "motion/flush.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace beespace {

namespace {

std::optional<Error> check_place(const Point& place, const char* name) {
  auto error = motion::check_position(motion::flushed(place), 0);
  if (!error) return error;
  error->location.record.reset();
  error->message.insert(0, name);
  return error;
}

}  // namespace

// Slowly enough to stop at the goal with half of the acceleration.
Result<Velocity> velocity_to_goal(const Point& position, const Point& goal,
                                  const FlightLimits& limits, double step_s) {
  if (auto error = check_place(position, "the bee's ")) return *std::move(error);
  if (auto error = check_place(goal, "the goal's ")) return *std::move(error);
  if (auto error = avoidance::check_step(step_s)) return *std::move(error);
  if (auto error = avoidance::check_limits(limits)) return *std::move(error);
  const core::Vector3 way = core::vector_of(goal) - core::vector_of(position);
  const double left_m = length(way);
  constexpr double kThere_m = 1e-9;  // no need to creep any nearer
  if (!(left_m > kThere_m)) return Velocity{};
  double speed = std::min(limits.max_speed_mps, left_m / step_s);
  if (std::isfinite(limits.max_acceleration_mps2)) {
    // At most a third of the remaining distance in a step: a velocity is flown half a step late on
    // average, and more than that makes a bee overshoot the goal and return.
    speed = std::min(
        {speed, std::sqrt(limits.max_acceleration_mps2 * left_m), left_m / (3.0 * step_s)});
  }
  const core::Vector3 velocity = way * (speed / left_m);
  return motion::flushed(Velocity{velocity.x, velocity.y, velocity.z});
}

}  // namespace beespace
