#include "avoidance/flyers.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::avoidance {

namespace {

// What rounding may take from a distance along the way: the distance is widened by it, and whoever
// keeps it is certified while at least half of it is left.
Keep keep(double asked_m, double farthest_m) {
  const double spare_m = 1e-7 * asked_m + 0x1p-44 * farthest_m;
  return {asked_m, asked_m + spare_m, asked_m + 0.5 * spare_m};
}

}  // namespace

void Flyers::take(const MoversView& movers, std::span<const FlightLimits> limits,
                  const AdviseOptions& options, Crew& crew) {
  flyers_.resize(movers.size());
  middles_.resize(movers.size());
  ways_.resize(movers.size());
  std::vector<Extremes> extremes(crew.size());  // of each worker's
  crew.split(movers.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    Extremes seen;
    for (std::size_t i = begin; i < end; ++i) {
      const auto [p, v] = movers[i];
      const FlightLimits& limit = limits[limits.size() == 1 ? 0 : i];
      const Flyer flyer{
          core::vector_of(p), core::vector_of(v), {limit, options.step_s}, limit.max_speed_mps};
      const Segment to_stop = flyer.way_to_stop();
      const Vector3 middle = to_stop.at(0.5);
      const double half_m = 0.5 * length(to_stop.way);
      const double reach_m =
          half_m + std::max(flyer.strays(), 0.5 * kPresses * options.threshold_m);
      flyers_[i] = flyer;
      middles_[i] = {middle.x, middle.y, middle.z};
      ways_[i] = {to_stop, half_m, flyer.strays(), reach_m};
      seen.add({reach_m, std::max(limit.max_speed_mps, length(flyer.velocity)),
                std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})});
    }
    extremes[worker] = seen;
  });
  extremes_ = {};
  for (const Extremes& seen : extremes) extremes_.add(seen);
  const double farthest_m = extremes_.farthest_m + 2.0 * extremes_.reach_m;
  apart_ = keep(options.threshold_m + 2.0 * options.uncertainty_m, farthest_m);
  clearance_ = keep(options.clearance_m + options.uncertainty_m, farthest_m);
}

}  // namespace beespace::avoidance
