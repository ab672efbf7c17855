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

AdviseMethod advise_method(Method method) {
  if (method == Method::kOrca) return AdviseMethod::kOrca;
  return method == Method::kMvp ? AdviseMethod::kMvp : AdviseMethod::kCertified;
}

}  // namespace

ClosedLoop::ClosedLoop(scenes::Mission mission, const LoopOptions& options)
    : mission_(std::move(mission)),
      options_(options),
      limits_(mission_.limits.empty() ? std::vector{options.limits} : mission_.limits),
      obstacles_(ObstacleMap::of(mission_.obstacles)),
      wishes_(mission_.starts.size()) {
  for (std::size_t bee = 0; bee < mission_.starts.size(); ++bee) {
    movers_.push_back({mission_.starts[bee], {}});
    Flight& flight = flights_.emplace_back();
    flight.shortest_m = distance_between(mission_.starts[bee], mission_.goals[bee]);
    if (flight.shortest_m > options_.arrived_m) continue;
    flight.arrived_s = 0.0;
    ++arrived_;
  }
}

const ObstacleMap* ClosedLoop::obstacles() const {
  return mission_.obstacles.empty() || !obstacles_ ? nullptr : &*obstacles_;
}

Velocity ClosedLoop::as_it_likes(std::size_t bee) const {
  const Velocity& v = movers_[bee].velocity;
  const Velocity& w = wishes_[bee];
  const double change = length(w.x - v.x, w.y - v.y, w.z - v.z);
  const double most = limits_of(bee).max_acceleration_mps2 * options_.advice.step_s;
  if (!(change > most)) return w;
  const double share = most / change;
  return {v.x + (w.x - v.x) * share, v.y + (w.y - v.y) * share, v.z + (w.z - v.z) * share};
}

Status ClosedLoop::step() {
  if (!obstacles_) return obstacles_.error();
  for (std::size_t bee = 0; bee < movers_.size(); ++bee) {
    const auto wish = velocity_to_goal(movers_[bee].position, mission_.goals[bee], limits_of(bee),
                                       options_.advice.step_s);
    if (!wish) {
      Error error = wish.error();
      error.location.record = bee;
      return error;
    }
    wishes_[bee] = *wish;
  }
  if (options_.method == Method::kNone) {
    for (std::size_t bee = 0; bee < movers_.size(); ++bee) fly(bee, as_it_likes(bee));
  } else {
    if (Status advised = take_advice(); !advised) return advised;
    for (std::size_t bee = 0; bee < movers_.size(); ++bee) fly(bee, advised_.advice[bee].velocity);
  }
  ++steps_;
  time_s_ = static_cast<double>(steps_) * options_.advice.step_s;
  for (std::size_t bee = 0; bee < movers_.size(); ++bee) look_at(bee);
  return std::monostate{};
}

Status ClosedLoop::take_advice() {
  AdviseOptions options = options_.advice;
  options.method = advise_method(options_.method);
  options.obstacles = obstacles();
  const auto begin = std::chrono::steady_clock::now();
  Status advised = adviser_.advise(movers_, wishes_, limits_, options, advised_);
  advising_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return advised;
}

void ClosedLoop::fly(std::size_t bee, const Velocity& next) {
  const auto [p, v] = movers_[bee];
  const bool at_once = std::isinf(limits_of(bee).max_acceleration_mps2);
  const Velocity mean =
      at_once ? next : Velocity{0.5 * (v.x + next.x), 0.5 * (v.y + next.y), 0.5 * (v.z + next.z)};
  const double dt = options_.advice.step_s;
  const Point q{p.x + mean.x * dt, p.y + mean.y * dt, p.z + mean.z * dt};
  if (!flights_[bee].arrived_s) flights_[bee].flown_m += distance_between(p, q);
  movers_[bee] = {q, next};
}

// Whether it has arrived, or is stuck.
void ClosedLoop::look_at(std::size_t bee) {
  Flight& flight = flights_[bee];
  if (flight.arrived_s) return;
  const auto& [p, v] = movers_[bee];
  const double left_m = distance_between(p, mission_.goals[bee]);
  if (left_m <= options_.arrived_m) {
    flight.arrived_s = time_s_;
    flight.flown_m += left_m;
    flight.stuck_since_s.reset();
    ++arrived_;
  } else if (length(v.x, v.y, v.z) < 0.05 * limits_of(bee).max_speed_mps) {
    flight.stuck_s += options_.advice.step_s;
    if (!flight.stuck_since_s) flight.stuck_since_s = time_s_ - options_.advice.step_s;
  } else {
    flight.stuck_since_s.reset();
  }
}

}  // namespace beespace::sim
