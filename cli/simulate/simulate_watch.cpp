#include "cli/simulate/simulate_watch.hpp"

#include <cmath>

namespace beespace::cli {
namespace {

// What rounding may add to a speed.
constexpr double kRelative = 1e-9;
constexpr double kOfSpeed = 1e-14;

double length(double x, double y, double z) {
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace

void SimulateWatch::see(const sim::ClosedLoop& loop) {
  if (!limits_.empty()) see_limits(loop.movers());
  if (const ObstacleMap* map = loop.obstacles()) see_obstacles(loop, *map);
}

// Velocities change evenly, so the ends of a step have the most.
void SimulateWatch::see_limits(const std::vector<Mover>& movers) {
  for (std::size_t bee = 0; bee < before_.size(); ++bee) {
    const Velocity& v = movers[bee].velocity;
    const Velocity& old = before_[bee].velocity;
    const double speed = length(v.x, v.y, v.z);
    const double change = length(v.x - old.x, v.y - old.y, v.z - old.z);
    const double most_change = limits_[bee].max_acceleration_mps2 * step_s_;
    if (speed > limits_[bee].max_speed_mps * (1.0 + kRelative)) ++figures_.breaches;
    if (change > most_change * (1.0 + kRelative) + kOfSpeed * speed) ++figures_.breaches;
  }
  before_ = movers;
}

void SimulateWatch::see_obstacles(const sim::ClosedLoop& loop, const ObstacleMap& map) {
  const std::vector<Mover>& movers = loop.movers();
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    const auto found = map.nearest(movers[bee].position, 2.0 * clearance_m_);
    if (!found) continue;
    const double distance_m = found->surface.distance_m;
    if (figures_.nearest && distance_m >= figures_.nearest->distance_m) continue;
    figures_.nearest = {static_cast<PointId>(bee), found->obstacle, distance_m, loop.time_s()};
  }
}

}  // namespace beespace::cli
