#include "sim/closed_loop.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

namespace beespace::sim {

namespace {

double length(double x, double y, double z) {
  return std::sqrt(x * x + y * y + z * z);
}

double distance_between(const Point& a, const Point& b) {
  return length(a.x - b.x, a.y - b.y, a.z - b.z);
}

}  // namespace

ClosedLoop::ClosedLoop(scenes::Mission mission, const LoopOptions& options)
    : mission_(std::move(mission)), options_(options), wishes_(mission_.starts.size()) {
  for (std::size_t bee = 0; bee < mission_.starts.size(); ++bee) {
    movers_.push_back({mission_.starts[bee], {}});
    Flight& flight = flights_.emplace_back();
    flight.shortest_m = distance_between(mission_.starts[bee], mission_.goals[bee]);
    if (flight.shortest_m > options_.arrived_m) continue;
    flight.arrived_s = 0.0;
    ++arrived_;
  }
}

// As fast as it can, and slowly enough to stop at the goal with half of its acceleration.
Velocity ClosedLoop::wish(std::size_t bee) const {
  const Point& p = movers_[bee].position;
  const Point& goal = mission_.goals[bee];
  const double left_m = distance_between(p, goal);
  constexpr double kThere_m = 1e-9;  // no need to creep any nearer
  if (!(left_m > kThere_m)) return {};
  const FlightLimits& limits = options_.limits;
  double speed = std::min(limits.max_speed_mps, left_m / options_.advice.step_s);
  if (std::isfinite(limits.max_acceleration_mps2)) {
    speed = std::min({speed, std::sqrt(limits.max_acceleration_mps2 * left_m),
                      0.5 * left_m / options_.advice.step_s});
  }
  const double share = speed / left_m;
  return {(goal.x - p.x) * share, (goal.y - p.y) * share, (goal.z - p.z) * share};
}

Velocity ClosedLoop::as_it_likes(std::size_t bee) const {
  const Velocity& v = movers_[bee].velocity;
  const Velocity& w = wishes_[bee];
  const double change = length(w.x - v.x, w.y - v.y, w.z - v.z);
  const double most = options_.limits.max_acceleration_mps2 * options_.advice.step_s;
  if (!(change > most)) return w;
  const double share = most / change;
  return {v.x + (w.x - v.x) * share, v.y + (w.y - v.y) * share, v.z + (w.z - v.z) * share};
}

Status ClosedLoop::step() {
  for (std::size_t bee = 0; bee < movers_.size(); ++bee) wishes_[bee] = wish(bee);
  if (options_.method == Method::kCertified) {
    const auto begin = std::chrono::steady_clock::now();
    Status advised = adviser_.advise(movers_, wishes_, std::span(&options_.limits, 1),
                                     options_.advice, advised_);
    if (!advised) return advised;
    advising_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (std::size_t bee = 0; bee < movers_.size(); ++bee) fly(bee, advised_.advice[bee].velocity);
  } else {
    for (std::size_t bee = 0; bee < movers_.size(); ++bee) fly(bee, as_it_likes(bee));
  }
  ++steps_;
  time_s_ = static_cast<double>(steps_) * options_.advice.step_s;
  for (std::size_t bee = 0; bee < movers_.size(); ++bee) {
    Flight& flight = flights_[bee];
    if (flight.arrived_s) continue;
    const auto& [p, v] = movers_[bee];
    const double left_m = distance_between(p, mission_.goals[bee]);
    if (left_m <= options_.arrived_m) {
      flight.arrived_s = time_s_;
      flight.flown_m += left_m;
      ++arrived_;
    } else if (length(v.x, v.y, v.z) < 0.05 * options_.limits.max_speed_mps) {
      flight.stuck_s += options_.advice.step_s;
    }
  }
  return std::monostate{};
}

void ClosedLoop::fly(std::size_t bee, const Velocity& next) {
  const auto [p, v] = movers_[bee];
  const bool at_once = std::isinf(options_.limits.max_acceleration_mps2);
  const Velocity mean =
      at_once ? next : Velocity{0.5 * (v.x + next.x), 0.5 * (v.y + next.y), 0.5 * (v.z + next.z)};
  const double dt = options_.advice.step_s;
  const Point q{p.x + mean.x * dt, p.y + mean.y * dt, p.z + mean.z * dt};
  if (!flights_[bee].arrived_s) flights_[bee].flown_m += distance_between(p, q);
  movers_[bee] = {q, next};
}

}  // namespace beespace::sim
