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
                  const AdviseOptions& options) {
  flyers_.clear();
  middles_.clear();
  ways_.clear();
  farthest_reach_m_ = 0.0;
  fastest_mps_ = 0.0;
  double farthest_m = 0.0;
  for (std::size_t i = 0; i < movers.size(); ++i) {
    const auto [p, v] = movers[i];
    const FlightLimits& limit = limits[limits.size() == 1 ? 0 : i];
    const Flyer& flyer = flyers_.emplace_back(Flyer{
        core::vector_of(p), core::vector_of(v), {limit, options.step_s}, limit.max_speed_mps});
    const Segment to_stop = flyer.way_to_stop();
    const Vector3 middle = to_stop.at(0.5);
    middles_.push_back({middle.x, middle.y, middle.z});
    const double half_m = 0.5 * length(to_stop.way);
    const double reach_m = half_m + std::max(flyer.strays(), 0.5 * kPresses * options.threshold_m);
    ways_.push_back({to_stop, half_m, flyer.strays(), reach_m});
    farthest_reach_m_ = std::max(farthest_reach_m_, reach_m);
    fastest_mps_ = std::max({fastest_mps_, limit.max_speed_mps, length(flyer.velocity)});
    farthest_m = std::max({farthest_m, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  farthest_m += 2.0 * farthest_reach_m_;
  apart_ = keep(options.threshold_m + 2.0 * options.uncertainty_m, farthest_m);
  clearance_ = keep(options.clearance_m + options.uncertainty_m, farthest_m);
}

}  // namespace beespace::avoidance
