#include "avoidance/known_methods.hpp"

#include "avoidance/constraints/velocity_obstacle.hpp"

#include <algorithm>

namespace beespace::avoidance {

double looks_ahead_s(const AgentStates& agents, double step_s) {
  constexpr double kAtOnce_s = 2.0;
  double longest_s = 0.0;
  for (std::size_t bee = 0; bee < agents.size(); ++bee) {
    const Braking& braking = agents[bee].braking;
    const double stop_s =
        braking.at_once() ? kAtOnce_s : agents[bee].max_speed * step_s / braking.change();
    longest_s = std::max(longest_s, stop_s);
  }
  return longest_s + step_s;
}

Vector3 KnownMethod::orca(const AgentStates& agents, PointId bee, const Vicinity& near,
                          const Vector3& preferred, double horizon_s, double step_s) {
  const AgentState& agent = agents[bee];
  requests_.clear();
  near.visit(bee, [&](PointId other) {
    const VelocityObstacle obstacle{agents[other].position - agent.position,
                                    agent.velocity - agents[other].velocity, agents.apart().kept_m,
                                    horizon_s, step_s};
    const HalfSpace side = half_space_of(obstacle.way_out(), agent.velocity, 0.5);
    requests_.push_back({side, std::max(0.0, side.offset + agent.max_speed)});
    return true;
  });
  const auto found = program_.nearest(preferred, {}, requests_, {{}, agent.max_speed});
  return agent.able(found.value_or(agent.velocity));
}

Vector3 KnownMethod::mvp(const AgentStates& agents, PointId bee, const Vicinity& near,
                         const Vector3& preferred, double horizon_s, double step_s) {
  const AgentState& agent = agents[bee];
  const double apart = agents.apart().kept_m;
  Vector3 sum = preferred;
  near.visit(bee, [&](PointId other) {
    const Vector3 place = agents[other].position - agent.position;
    const Vector3 velocity = preferred - agents[other].velocity;  // seen from the other one
    const double squared = dot(velocity, velocity);
    const double closest_s =
        squared > 0.0 ? std::clamp(dot(place, velocity) / squared, 0.0, horizon_s) : 0.0;
    const Vector3 miss = velocity * closest_s - place;  // from the other one, when closest
    const double missed = length(miss);
    if (missed >= apart) return true;
    const Vector3 away = missed > 1e-9 * apart ? miss * (1.0 / missed) : right_of(place);
    sum = sum + away * ((apart - missed) / std::max(closest_s, step_s));
    return true;
  });
  return agent.able(sum);
}

}  // namespace beespace::avoidance
