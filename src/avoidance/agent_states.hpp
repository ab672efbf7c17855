// The states of all agents at the beginning of a step, and their separation margins.
#pragma once

#include "avoidance/agent_state.hpp"
#include "avoidance/claims.hpp"

#include <beespace/advise.hpp>
#include <beespace/crew.hpp>
#include <beespace/mover.hpp>
#include <beespace/pairs.hpp>
#include <beespace/points_view.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace beespace::avoidance {

// A distance to keep, with its allowance for rounding.
struct SeparationMargins {
  double asked_m = 0.0;
  double kept_m = 0.0;       // a little more, for rounding
  double certified_m = 0.0;  // closer than this, the allowance for rounding is used up

  // The same with a larger allowance.
  [[nodiscard]] SeparationMargins with(double spare_m) const {
    return {asked_m, kept_m + spare_m, certified_m + 0.5 * spare_m};
  }
};

// As a share of the distance to keep: an agent at most so much farther away presses others.
inline constexpr double kPresses = 0.6;

class AgentStates {
 public:
  // `limits` has one for each or one for all; options.claims one for each or none.
  void take(std::span<const Mover> movers, std::span<const Velocity> preferred,
            std::span<const FlightLimits> limits, const AdviseOptions& options, Crew& crew);

  [[nodiscard]] std::size_t size() const { return agents_.size(); }
  [[nodiscard]] const AgentState& operator[](std::size_t bee) const { return agents_[bee]; }
  // The stopping segment at the present velocity.
  [[nodiscard]] const Segment& stopping_segment(std::size_t bee) const {
    return ways_[bee].to_stop;
  }
  // How far from its end the step and the stop after it may take the agent.
  [[nodiscard]] double strays(std::size_t bee) const { return ways_[bee].strays_m; }
  // Whether the agent is at its goal: it prefers to fly far slower than it can.
  [[nodiscard]] bool is_idle(std::size_t bee) const { return ways_[bee].idle; }
  [[nodiscard]] double fastest() const { return extremes_.speed_mps; }
  [[nodiscard]] const Claims& claims() const { return claims_; }

  // The distance to keep where coordinates are small; for two bees; for a bee and an object near it
  // whose coordinates or size may be as large.
  [[nodiscard]] const SeparationMargins& apart() const { return apart_; }
  [[nodiscard]] SeparationMargins apart(PointId bee, PointId other) const {
    return apart_.with(std::max(ways_[bee].spare_m, ways_[other].spare_m));
  }
  [[nodiscard]] SeparationMargins apart_from(double large_m, PointId bee) const {
    const SeparationMargins& apart = claims_.any() ? keep(claims_.from_stranger_m(bee)) : apart_;
    return apart.with(ways_[bee].spare_m + spare_m(large_m));
  }
  // What is asked of two that are level with each other.
  [[nodiscard]] double asked_m(const Pair& pair) const {
    if (!claims_.any()) return apart_.asked_m;
    const FreeBetween between = claims_.between(pair.first, pair.second);
    return between.horizontal_m + between.beyond_m;
  }
  // As apart() for two claims, where so much must stay free along a normal.
  [[nodiscard]] SeparationMargins apart_by(double free_m, PointId bee, PointId other) const {
    return keep(free_m).with(std::max(ways_[bee].spare_m, ways_[other].spare_m));
  }
  // The clearance of obstacles and fences.
  [[nodiscard]] SeparationMargins clearance(PointId bee) const {
    const double tube_m = claims_.tube_m(bee);
    return (tube_m > 0.0 ? keep(clearance_.asked_m + tube_m) : clearance_).with(ways_[bee].spare_m);
  }

  // A ball contains the claim, all places of the step and of the stop after it, and half of the
  // distance within which the agent presses others; and what the agent's tube and radius add.
  [[nodiscard]] PointsView middles() const { return std::span<const Point>(middles_); }
  [[nodiscard]] double reach(std::size_t bee) const { return ways_[bee].reach_m; }
  [[nodiscard]] double farthest_reach() const { return extremes_.reach_m; }
  // Two agents whose segments' midpoints are farther apart than this cannot interact, whatever both
  // do: two that reach so far; these two.
  [[nodiscard]] double meet(double reach_m, double other_reach_m) const {
    return (widest_m_ + reach_m + other_reach_m) * (1.0 + 0x1p-40);
  }
  [[nodiscard]] bool may_meet(PointId bee, PointId other) const {
    const Vector3 between = core::vector_of(middles_[bee]) - core::vector_of(middles_[other]);
    const double meet_m = meet(ways_[bee].reach_m, ways_[other].reach_m);
    return dot(between, between) <= meet_m * meet_m;
  }
  // False where two stopping segments, or claims, are surely farther apart than this.
  [[nodiscard]] bool ways_may_be_within(PointId bee, PointId other, double apart_m) const {
    const Vector3 between = core::vector_of(middles_[bee]) - core::vector_of(middles_[other]);
    const double within_m = (apart_m + ways_[bee].half_m + ways_[other].half_m) * (1.0 + 0x1p-40);
    return dot(between, between) <= within_m * within_m;
  }

 private:
  struct Way {
    Segment to_stop;
    double half_m;  // as long; of a claim the radius of its ball
    double strays_m;
    double reach_m;
    double spare_m;  // for the rounding of its coordinates; part of its reach
    bool idle;
  };
  // What rounding may take from a distance along the stopping segment: the distance is widened by
  // it, and an agent that keeps it is certified while at least half of the margin is left.
  static SeparationMargins keep(double asked_m) {
    return SeparationMargins{asked_m, asked_m, asked_m}.with(1e-7 * asked_m);
  }
  // The allowance for the rounding of coordinates of this size. Each bee has its own: one that is
  // far astray must not widen the margins of those that are nowhere near it.
  static double spare_m(double large_m) { return 0x1p-44 * large_m; }

  // The greatest values of all agents.
  struct Extremes {
    double reach_m = 0.0;
    double speed_mps = 0.0;

    void add(const Extremes& other) {
      reach_m = std::max(reach_m, other.reach_m);
      speed_mps = std::max(speed_mps, other.speed_mps);
    }
  };

  std::vector<Point> middles_;  // of the ways or claims
  std::vector<Way> ways_;
  std::vector<AgentState> agents_;
  Extremes extremes_;
  std::vector<Extremes> seen_;   // of each worker's
  SeparationMargins apart_;      // from each other
  SeparationMargins clearance_;  // from obstacles
  double widest_m_ = 0.0;        // what must stay free in any direction, to be kept
  Claims claims_;
};

}  // namespace beespace::avoidance
