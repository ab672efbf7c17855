#include "avoidance/constraint_builder.hpp"

#include "avoidance/constraints/hull_obstacle_separation.hpp"
#include "avoidance/constraints/velocity_obstacle.hpp"
#include "obstacles/obstacle_map.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace beespace::avoidance {

namespace {

Vector3 preferred_of(std::span<const Velocity> preferred, PointId bee) {
  return core::vector_of(preferred[bee]);
}

}  // namespace

void ConstraintBuilder::look_at(PointId bee, Findings& findings) const {
  findings.constraints.clear();
  findings.pressed = {};
  findings.certified = true;
  findings.clear_of_unknown_s = std::numeric_limits<double>::infinity();
  look_at_bees(bee, findings);
  if (options_.obstacles != nullptr) look_at_obstacles(bee, findings);
  look_at_fences(bee, findings);
  look_at_intruders(bee, findings);
  look_at_unknown(bee, findings);
}

// The one of the lower id is the first.
SeparatingPlane ConstraintBuilder::plane_between(PointId bee, PointId other) const {
  const Segment& first = agents_.stopping_segment(std::min(bee, other));
  const Segment& second = agents_.stopping_segment(std::max(bee, other));
  return separate(first, second, agents_.apart(bee, other).kept_m);
}

bool ConstraintBuilder::is_too_close(PointId bee, PointId other) const {
  const double certified_m = agents_.apart(bee, other).certified_m;
  return agents_.ways_may_be_within(bee, other, certified_m) &&
         plane_between(bee, other).gap < certified_m;
}

void ConstraintBuilder::mark_too_close(PointId bee, std::span<char> marks) const {
  const bool claims = agents_.claims().any();
  near_.visit(bee, [&](PointId other) {
    if (other < bee) return true;
    if (!(claims ? is_claim_too_close(bee, other) : is_too_close(bee, other))) return true;
    for (const PointId one : {bee, other}) {
      std::atomic_ref(marks[one]).store(1, std::memory_order_relaxed);
    }
    return true;
  });
}

void ConstraintBuilder::look_at_bees(PointId bee, Findings& findings) const {
  if (agents_.claims().any()) {
    near_.visit(bee, [&](PointId other) {
      if (agents_.may_meet(bee, other)) look_at_claim(bee, other, findings);
      return true;
    });
    return;
  }
  near_.visit(bee, [&](PointId other) {
    if (agents_.may_meet(bee, other)) look_at_bee(bee, other, findings);
    return true;
  });
}

void ConstraintBuilder::look_at_bee(PointId bee, PointId other, Findings& findings) const {
  const auto [asked_m, kept_m, certified_m] = agents_.apart(bee, other);
  Constraints& constraints = findings.constraints;
  const bool is_first = bee < other;
  const SeparatingPlane plane = plane_between(bee, other);
  const double lean = is_first ? leaves_to(bee, other) : leaves_to(other, bee);
  const HalfSpace side = is_first ? plane.of_first(kept_m, lean) : plane.of_second(kept_m, lean);
  const bool certified = plane.gap >= certified_m;
  const double free_m = plane.gap - agents_.apart().kept_m;
  findings.pressed = findings.pressed + pressure(other, side.normal, free_m, certified);
  if (certified && is_kept_anyhow(bee, side)) return;
  constraints.hard.push_back(side);
  if (certified) return;
  findings.certified = false;
  constraints.separation_requests.push_back(
      {constraints.hard.size() - 1, 0.5 * (kept_m - plane.gap)});
  if (is_first) findings.too_close.push_back({{bee, other}, plane.gap, 0.0});
}

void ConstraintBuilder::look_at_obstacles(PointId bee, Findings& findings) const {
  const Segment& way = agents_.stopping_segment(bee);
  const double kept_m = agents_.clearance(bee).kept_m;
  const double reach_m = (kept_m + agents_.reach(bee)) * (1.0 + 0x1p-40);
  const Vector3 middle = core::vector_of(agents_.middles()[bee]);
  const ObstacleMap::State& map = options_.obstacles->state();
  // The pieces of an obstacle that contains the bee are no walls: it may have to get out through
  // them.
  std::vector<std::size_t>& inside = findings.inside;
  inside.clear();
  map.visit_near(way.from, 0.0, [&](const obstacles::ConvexPiece& piece) {
    if (map.facing(piece.obstacle(), way.from).surface.distance_m < 0.0) {
      inside.push_back(piece.obstacle());
    }
  });
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
  for (const std::size_t obstacle : inside) {
    const obstacles::Facing out = map.facing(obstacle, way.from);
    keep_clear(bee, obstacle,
               agents_.claims().any() ? part_inside(agents_.claims().hull(bee), out)
                                      : part_inside(way, out),
               findings);
  }
  map.visit_near(middle, reach_m, [&](const obstacles::ConvexPiece& piece) {
    if (std::binary_search(inside.begin(), inside.end(), piece.obstacle())) return;
    keep_clear(bee, piece.obstacle(),
               agents_.claims().any() ? separation_of_piece(bee, piece, findings)
                                      : separate(way, piece, kept_m),
               findings);
  });
}

void ConstraintBuilder::keep_clear(PointId bee, std::size_t obstacle,
                                   const ObstacleSeparation& plane, Findings& findings) const {
  const SeparationMargins margins = agents_.clearance(bee);
  keep_to(bee, plane.of_way(margins.kept_m), plane.gap, margins, findings);
  if (plane.gap < margins.certified_m) findings.near_obstacle.push_back({bee, obstacle, plane.gap});
}

void ConstraintBuilder::keep_to(PointId bee, const HalfSpace& side, double gap_m,
                                const SeparationMargins& margins, Findings& findings) const {
  const bool certified = gap_m >= margins.certified_m;
  if (certified && is_kept_anyhow(bee, side)) return;
  if (!certified) findings.certified = false;
  if (is_out_of_plane(side)) return;
  Constraints& constraints = findings.constraints;
  constraints.hard.push_back(side);
  if (certified) return;
  constraints.separation_requests.push_back({constraints.hard.size() - 1, margins.kept_m - gap_m});
}

void ConstraintBuilder::look_at_intruders(PointId bee, Findings& findings) const {
  const AgentState& agent = agents_[bee];
  for (std::size_t k = 0; k < options_.intruders.size(); ++k) {
    const auto [p, v] = options_.intruders[k];
    if (!may_come_close(bee, k)) continue;
    const Vector3 place = core::vector_of(p) - agent.position;
    const Vector3 velocity = core::vector_of(v);
    const VelocityObstacle obstacle{place, agent.velocity - velocity,
                                    agents_.apart_from(0.0, bee).kept_m + intruder_margin_m(k),
                                    options_.intruder_horizon_s, options_.step_s};
    findings.constraints.intruder_requests.push_back(half_space_of(
        obstacle.is_too_close() ? obstacle.away()
                                : obstacle.way_out_within(agent.velocity, agent.max_speed),
        agent.velocity, 1.0));
  }
}

// A bee that keeps its constraints comes no closer to the centre of a ball than its stopping
// segment is now, or than the ball's radius at the horizon plus the distance to keep. As that grows
// from call to call, a bee that was once clear for a time stays so (docs/prevention.md).
void ConstraintBuilder::look_at_unknown(PointId bee, Findings& findings) const {
  const double horizon_s = options_.unknown_horizon_s;
  for (std::size_t k = 0; k < options_.unknown.size(); ++k) {
    const UnknownAgent& ball = options_.unknown[k];
    // Rounded up.
    const double later_m = (ball.radius_m + ball.growth_mps * horizon_s) * (1.0 + 0x1p-50);
    if (ball.growth_mps > 0.0) {
      findings.clear_of_unknown_s = std::min(findings.clear_of_unknown_s, horizon_s);
    }
    const Vector3 between = core::vector_of(agents_.middles()[bee]) - core::vector_of(ball.center);
    const double meet_m = agents_.meet(agents_.reach(bee), later_m);
    if (dot(between, between) <= meet_m * meet_m) keep_clear_of_ball(bee, k, later_m, findings);
  }
}

void ConstraintBuilder::keep_clear_of_ball(PointId bee, std::size_t unknown, double later_m,
                                           Findings& findings) const {
  const UnknownAgent& ball = options_.unknown[unknown];
  const auto [asked_m, kept_m, certified_m] = agents_.apart_from(later_m, bee);
  const Segment middle{core::vector_of(ball.center), {}};
  const double apart_m = later_m + kept_m;
  const SeparatingPlane plane = plane_to(bee, middle, apart_m);
  // The centre does not move: all of the free distance is the bee's.
  const HalfSpace side = plane.of_first(apart_m, -1.0);
  Constraints& constraints = findings.constraints;
  const bool clear = plane.gap >= later_m + certified_m;
  if (clear && is_kept_anyhow(bee, side)) return;
  constraints.hard.push_back(side);
  if (clear) return;
  constraints.separation_requests.push_back({constraints.hard.size() - 1, apart_m - plane.gap});
  const double left_m = plane.gap - certified_m - ball.radius_m;
  double clear_s = 0.0;
  if (left_m >= 0.0 && ball.growth_mps > 0.0) {
    clear_s = left_m * (1.0 - 0x1p-50) / ball.growth_mps;
  }
  findings.clear_of_unknown_s = std::min(findings.clear_of_unknown_s, clear_s);
  findings.near_unknown.push_back({bee, unknown, plane.gap - ball.radius_m, clear_s});
}

double ConstraintBuilder::intruder_margin_m(std::size_t k) const {
  return options_.intruder_margins_m.empty() ? 0.0 : options_.intruder_margins_m[k];
}

bool ConstraintBuilder::may_come_close(PointId bee, std::size_t k) const {
  const Mover intruder = options_.intruders[k];
  const Vector3 between = core::vector_of(intruder.position) - agents_[bee].position;
  const AgentState& agent = agents_[bee];
  const double speeds = length(core::vector_of(intruder.velocity)) +
                        std::max(agent.max_speed, length(agent.velocity));
  const double far_m = agents_.apart_from(0.0, bee).kept_m + intruder_margin_m(k) +
                       speeds * options_.intruder_horizon_s;
  return dot(between, between) <= far_m * far_m;
}

// Whether a bee stops within a half-space whatever it does in the step.
bool ConstraintBuilder::is_kept_anyhow(PointId bee, const HalfSpace& side) const {
  return is_out_of_plane(side) ||
         side.inside_by(agents_.stopping_segment(bee).at(1.0)) >= agents_.strays(bee);
}

// An agent at its goal leaves most of the free space to one that wants to fly: how much more than
// half the first leaves to the second, as a share of that half. One that holds leaves all.
double ConstraintBuilder::leaves_to(PointId first, PointId second) const {
  constexpr double kLeft = 0.9;
  const bool first_holds = agents_.claims().holds(first);
  if (first_holds != agents_.claims().holds(second)) return first_holds ? 1.0 : -1.0;
  return kLeft * ((is_idle(first) ? 1.0 : 0.0) - (is_idle(second) ? 1.0 : 0.0));
}

// An agent at its goal makes room for agents that are close and want through, or are too close to
// another one: how much `other` presses an agent that lies from it in the direction `away`, across
// a free distance.
Vector3 ConstraintBuilder::pressure(PointId other, const Vector3& away, double free_m,
                                    bool certified) const {
  const double free = free_m / (kPresses * agents_.apart().kept_m);
  if (free >= 1.0) return {};
  const bool wants_through = !is_idle(other) && dot(preferred_of(preferred_, other), away) > 0.0;
  // A pair that is too close separates anyhow.
  const bool needs_room = too_close_[other] != 0 && certified;
  if (!wants_through && !needs_room) return {};
  return away * (1.0 - free);
}

}  // namespace beespace::avoidance
