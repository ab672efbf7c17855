#include "cli/watch/nominal_flight.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace beespace::cli {
namespace {

// Reports are compared with the path so far back.
constexpr std::size_t kMostNodes = 8;
// Steps: after a longer silence a bee is anywhere, and its path need not take longer.
constexpr Tick kMostAhead = 64;

double length(double x, double y, double z) {
  return std::hypot(x, y, z);
}

double between(const Velocity& a, const Velocity& b) {
  return length(a.x - b.x, a.y - b.y, a.z - b.z);
}

Velocity mix(const Velocity& from, const Velocity& to, double share) {
  return {from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share,
          from.z + (to.z - from.z) * share};
}

// As near to the aim as the acceleration leads within the time.
Velocity reached(const Velocity& from, const Velocity& aim, double within_s,
                 double max_acceleration_mps2) {
  const double most = max_acceleration_mps2 * within_s;
  const double asked = between(from, aim);
  // What is told differs by no more than most, but for rounding.
  if (asked <= most * (1 + 1e-9)) return aim;
  return mix(from, aim, most / asked);
}

Point moved(const Point& from, const Velocity& velocity, double for_s) {
  return {from.x + velocity.x * for_s, from.y + velocity.y * for_s, from.z + velocity.z * for_s};
}

}  // namespace

void NominalFlight::add(const Velocity& aim, bool told, const AdviceTicks& ticks,
                        double max_acceleration_mps2) {
  const Node& from = nodes_.back();
  const Tick tick = from.tick + 1;
  // Between two ticks it is a step, exactly: differences of late times are not.
  const double lasts_s = nodes_.size() == 1 && from.lasts_s == 0.0
                             ? ticks.time_of(tick) - from.time_s
                             : ticks.step_s();
  const Velocity& before = from.mover.velocity;
  const Velocity after = reached(before, aim, lasts_s, max_acceleration_mps2);
  const Velocity mean = std::isinf(max_acceleration_mps2) ? after : mix(before, after, 0.5);
  const Node next{
      ticks.time_of(tick), lasts_s, {moved(from.mover.position, mean, lasts_s), after}, tick, told};
  nodes_.push_back(next);
  if (nodes_.size() > kMostNodes) nodes_.pop_front();
}

void NominalFlight::anchor(double time_s, const Mover& mover, const AdviceTicks& ticks,
                           double max_acceleration_mps2) {
  const Tick tick = ticks.at_or_before(time_s);
  const std::deque<Node> before =
      std::exchange(nodes_, std::deque<Node>{{time_s, 0.0, mover, tick, false}});
  for (const Node& node : before) {
    if (node.tick <= tick || node.lasts_s == 0.0) continue;
    if (node.tick - end_tick() > kMostAhead) break;
    while (end_tick() + 1 < node.tick) add(end().velocity, false, ticks, max_acceleration_mps2);
    add(node.told ? node.mover.velocity : end().velocity, node.told, ticks, max_acceleration_mps2);
  }
}

void NominalFlight::extend(Tick until, bool advised, const AdviceTicks& ticks,
                           double max_acceleration_mps2) {
  if (until - end_tick() > kMostAhead) {
    Node& last = nodes_.back();
    last.tick = until - kMostAhead;
    last.time_s = ticks.time_of(last.tick);
    nodes_.erase(nodes_.begin(), std::prev(nodes_.end()));
  }
  while (end_tick() < until) {
    add(advised ? Velocity{} : end().velocity, advised, ticks, max_acceleration_mps2);
  }
}

void NominalFlight::fly(const Velocity& velocity, bool told, const AdviceTicks& ticks,
                        double max_acceleration_mps2) {
  add(velocity, told, ticks, max_acceleration_mps2);
}

double NominalFlight::deviation_m(double time_s, const Mover& mover, double ahead_s,
                                  double max_acceleration_mps2) const {
  // The piece in which the time is; beyond the end straight on.
  std::size_t after = 0;
  while (after < nodes_.size() && nodes_[after].time_s < time_s) ++after;
  const bool beyond = after == nodes_.size();
  Point position = nodes_[beyond ? after - 1 : after].mover.position;
  Velocity velocity = nodes_[beyond ? after - 1 : after].mover.velocity;
  if (beyond) {
    position = moved(position, velocity, time_s - nodes_.back().time_s);
  } else if (after == 0) {
    position = moved(position, velocity, time_s - nodes_.front().time_s);
  } else {
    const Node& from = nodes_[after - 1];
    const double share = (time_s - from.time_s) / (nodes_[after].time_s - from.time_s);
    if (std::isinf(max_acceleration_mps2)) {
      position = moved(from.mover.position, velocity, share * nodes_[after].lasts_s);
    } else {
      const Velocity there = mix(from.mover.velocity, velocity, share);
      position = moved(from.mover.position, mix(from.mover.velocity, there, 0.5),
                       share * nodes_[after].lasts_s);
      velocity = there;
    }
  }
  double off_mps = between(mover.velocity, velocity);
  if (std::isinf(max_acceleration_mps2) && after + 1 < nodes_.size()) {
    // At a tick it has both velocities.
    constexpr double kShare = 0.01;
    if (nodes_[after].time_s - time_s < kShare * nodes_[after + 1].lasts_s) {
      off_mps = std::min(off_mps, between(mover.velocity, nodes_[after + 1].mover.velocity));
    }
  }
  return length(mover.position.x - position.x, mover.position.y - position.y,
                mover.position.z - position.z) +
         off_mps * ahead_s;
}

}  // namespace beespace::cli
