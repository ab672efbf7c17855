#include "avoidance/velocity_solver.hpp"

#include "avoidance/constraints/sideways.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::avoidance {

namespace {

// The path in the step lies between the start, the point half the old velocity on, and the stop
// after the new one. It is within the half-spaces if the stop is, as the first two lie on the old
// stopping segment.
bool keeps_to(const AgentState& agent, const Vector3& velocity, const Constraints& constraints) {
  const Vector3 stop = agent.stop_after(velocity);
  return std::all_of(constraints.hard.begin(), constraints.hard.end(),
                     [&](const HalfSpace& side) { return side.inside_by(stop) >= 0.0; });
}

// Whether the velocity meets the requests, too.
bool does_all(const AgentState& agent, const Vector3& velocity, const Constraints& constraints) {
  const Vector3 stop = agent.stop_after(velocity);
  return std::all_of(constraints.separation_requests.begin(), constraints.separation_requests.end(),
                     [&](const Constraints::Farther& farther) {
                       return constraints.hard[farther.of].inside_by(stop) >= farther.by;
                     }) &&
         std::all_of(constraints.intruder_requests.begin(), constraints.intruder_requests.end(),
                     [&](const HalfSpace& side) { return side.inside_by(velocity) >= 0.0; });
}

double sum_of(const Vector3& a) {
  return std::abs(a.x) + std::abs(a.y) + std::abs(a.z);
}

// How far outside of a half-space the program's result may be: for its own rounding, and for that
// of the stop and of its distance to the plane.
double rounding_of(const AgentState& agent, const Vector3& from, double most_change) {
  return 0x1p-50 * (sum_of(agent.position) + sum_of(agent.stop_after(from))) +
         0x1p-38 * most_change * agent.braking.growth_along(length(from) + most_change);
}

// The half-space of the horizontal velocities in one of all velocities; false where it is all of
// them or none, or nearly so.
bool put_in_plane(HalfSpace& side) {
  constexpr double kUpright = 1e-9;
  const Vector3 level{side.normal.x, side.normal.y, 0.0};
  const double long_m = length(level);
  if (!(long_m > kUpright)) return false;
  side = {level * (1.0 / long_m), side.offset / long_m};
  return true;
}

// The preferred velocity, turned to the right as seen from above, by the angle of this sine.
Vector3 turned_right(const Vector3& preferred, double sine) {
  const double speed = length(preferred);
  return preferred * std::sqrt(1.0 - sine * sine) + right_of(preferred) * (speed * sine);
}

}  // namespace

VelocitySolver::Solved VelocitySolver::solve(const AgentState& agent, const Vector3& preferred,
                                             const Constraints& constraints) {
  const Vector3 proposed = agent.able(preferred);
  if (keeps_to(agent, proposed, constraints) && does_all(agent, proposed, constraints)) {
    return {proposed, AdviceKind::kAsPreferred};
  }
  const Braking& braking = agent.braking;
  const Vector3 brake = braking.at_once() ? Vector3{} : braking.braked(agent.velocity);
  const Vector3 from = braking.at_once() ? Vector3{} : agent.velocity;
  const Ball changes{{}, braking.at_once() ? agent.max_speed : braking.change()};
  const auto nearest = [&](const Vector3& velocity) {
    // An agent that slides along a plane must not be told to stand because rounding puts it
    // outside. Where there is no room for that, the plane itself has to do.
    for (const double within : {rounding_of(agent, from, changes.radius), 0.0}) {
      put_in_changes(agent, from, constraints, changes.radius, within);
      const auto found = program_.nearest(velocity - from, firm_, requests_, changes);
      if (found) return agent.able(from + *found);
    }
    return velocity;
  };
  Vector3 best = nearest(proposed);
  // An agent that makes too little progress straight on turns right, the more the less it makes. So
  // two that meet pass each other, and many that meet go round.
  constexpr double kEnough = 0.6;
  const double progress = std::max(0.0, dot(best, preferred) / dot(preferred, preferred));
  if (progress < kEnough) {
    best = nearest(agent.able(turned_right(preferred, 1.0 - progress / kEnough)));
  }
  // Corrects the linearised curve: a little towards braking.
  for (const double share : {1.0, 0.999, 0.99, 0.9, 0.7, 0.4, 0.15, 0.05}) {
    const Vector3 velocity = brake + (best - brake) * share;
    if (keeps_to(agent, velocity, constraints)) return {velocity, AdviceKind::kDeflected};
  }
  return {brake, AdviceKind::kBraking};
}

// The half-spaces, shrunk by `within`, for small changes of the velocity: a change across it and
// one along it move the stop by different lengths.
void VelocitySolver::put_in_changes(const AgentState& agent, const Vector3& from,
                                    const Constraints& constraints, double most_change,
                                    double within) {
  const double speed = length(from);
  const double across = agent.braking.growth_across(speed);
  const double along = agent.braking.growth_along(speed);
  const Vector3 heading = speed > 0.0 ? from * (1.0 / speed) : Vector3{};
  const Vector3 stop = agent.stop_after(from);
  const auto in_changes = [&](const HalfSpace& side, double farther) {
    const Vector3& n = side.normal;
    Vector3 slope = n * across + heading * (dot(n, heading) * (along - across));
    if (agent.planar) slope.z = 0.0;
    const double steep = length(slope);
    return HalfSpace{slope * (1.0 / steep), (farther - side.inside_by(stop)) / steep};
  };
  firm_.clear();
  for (const HalfSpace& side : constraints.hard) firm_.push_back(in_changes(side, within));
  requests_.clear();
  for (const auto& [of, by] : constraints.separation_requests) {
    const HalfSpace side = in_changes(constraints.hard[of], by);
    requests_.push_back({side, side.offset - firm_[of].offset});
  }
  for (const HalfSpace& side : constraints.intruder_requests) {
    HalfSpace change{side.normal, -side.inside_by(from)};
    if (agent.planar && !put_in_plane(change)) continue;
    // All possible changes satisfy it once it has been relaxed by as much.
    requests_.push_back({change, std::max(0.0, change.offset + most_change)});
  }
}

}  // namespace beespace::avoidance
