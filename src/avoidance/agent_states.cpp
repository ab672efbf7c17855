#include "avoidance/agent_states.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::avoidance {

namespace {

// The allowance for values that are too small for the motion domain and count as zero. Each
// coordinate changes by less than 2^-100, so a place and a velocity by less than 2^-99 (see
// motion/flush.hpp). The place moves the stop by as much; the old and the new velocity move it by
// up to growth_along times as much each, as no slope of the stopping segment is above that. So for
// two bees, at both ends of a step, it is less than 2^-95 (1 + growth_along): half of this is sixty
// times as much.
double spare_for_flushed(const AgentState& agent) {
  const Braking& braking = agent.braking;
  return 0x1p-88 * (1.0 + (braking.at_once()
                               ? braking.step_s()
                               : braking.growth_along(length(agent.velocity) + braking.change())));
}

}  // namespace

void AgentStates::take(std::span<const Mover> movers, std::span<const Velocity> preferred,
                       std::span<const FlightLimits> limits, const AdviseOptions& options,
                       Crew& crew) {
  constexpr double kIdle = 0.3;  // of what it can fly
  agents_.resize(movers.size());
  middles_.resize(movers.size());
  ways_.resize(movers.size());
  seen_.assign(crew.size(), {});
  claims_.start(movers.size(), options.claims, options);
  crew.split(movers.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    Extremes seen;
    for (std::size_t i = begin; i < end; ++i) {
      const auto [p, v] = movers[i];
      const FlightLimits& limit = limits[limits.size() == 1 ? 0 : i];
      const AgentState agent{core::vector_of(p),
                             core::vector_of(v),
                             {limit, options.step_s},
                             limit.max_speed_mps,
                             options.planar};
      const Segment to_stop = agent.stopping_segment();
      const auto [middle, half_m] = claims_.any()
                                        ? claims_.take(i, to_stop)
                                        : Enclosing{to_stop.at(0.5), 0.5 * length(to_stop.way)};
      const double strays_m = claims_.holds(i) ? 0.0 : agent.strays();
      const double gets_m = half_m + std::max(strays_m, 0.5 * kPresses * options.threshold_m);
      const double far_m = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      const double own_spare_m = spare_m(far_m + 2.0 * gets_m) + spare_for_flushed(agent);
      const double reach_m = gets_m + own_spare_m + keep(claims_.widens_m(i)).kept_m;
      agents_[i] = agent;
      middles_[i] = {middle.x, middle.y, middle.z};
      const bool idle = length(core::vector_of(preferred[i])) < kIdle * agent.max_speed;
      ways_[i] = {to_stop, half_m, strays_m, reach_m, own_spare_m, idle};
      seen.add({reach_m, std::max(limit.max_speed_mps, length(agent.velocity))});
    }
    seen_[worker] = seen;
  });
  extremes_ = {};
  for (const Extremes& seen : seen_) extremes_.add(seen);
  apart_ = keep(options.threshold_m + 2.0 * options.uncertainty_m);
  widest_m_ =
      claims_.any()
          ? keep(claims_.shape().widest(options.threshold_m) + 2.0 * options.uncertainty_m).kept_m
          : apart_.kept_m;
  clearance_ = keep(options.clearance_m + options.uncertainty_m);
}

}  // namespace beespace::avoidance
