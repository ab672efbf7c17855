// The arithmetic of nominal paths. A planner and an agent compute them apart, and must get the same
// doubles; so both use this.
//
// A path has states at successive ticks. In a tick the velocity changes evenly from one state to
// the next. After the last state comes the fallback: the agent brakes as hard as it can, straight
// on, until it stands, and stays there for ever. Corrections end with the last state.
#pragma once

#include "avoidance/constraints/braking.hpp"
#include "base/vector3.hpp"

#include <beespace/command.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace beespace::fleet {

using avoidance::Braking;
using core::Vector3;

inline Point point_of(const Vector3& a) {
  return {a.x, a.y, a.z};
}
inline Velocity velocity_of(const Vector3& a) {
  return {a.x, a.y, a.z};
}

// How many ticks `later` is after `earlier`; it is no earlier. No int64 holds all of them.
inline std::uint64_t ticks_between(Tick earlier, Tick later) {
  return static_cast<std::uint64_t>(later) - static_cast<std::uint64_t>(earlier);
}

// A tick later, with this velocity at its end.
inline Mover step_to(const Mover& from, const Velocity& next, double period_s) {
  const Vector3 both = core::vector_of(from.velocity) + core::vector_of(next);
  return {point_of(core::vector_of(from.position) + both * (0.5 * period_s)), next};
}

inline Velocity braked(const Velocity& velocity, const Braking& braking) {
  return velocity_of(braking.braked(core::vector_of(velocity)));
}

// A tick of the fallback.
inline Mover braked_step(const Mover& from, const Braking& braking) {
  return step_to(from, braked(from.velocity, braking), braking.step_s());
}

inline bool stands(const Mover& mover) {
  return mover.velocity == Velocity{};
}

// So many ticks of the fallback. It ends early where the agent stands: as soon as that can be.
inline Mover after_braking(Mover state, std::uint64_t ticks, const Braking& braking) {
  for (; ticks > 0 && !stands(state); --ticks) state = braked_step(state, braking);
  return state;
}

// The same of a state of a path: its correction ends with it.
inline BranchState after_last(const BranchState& last, std::uint64_t ticks,
                              const Braking& braking) {
  if (ticks == 0) return last;
  return {after_braking(last.nominal, ticks, braking), {}};
}

// States at `starts` and each tick after it; at least one.
struct Path {
  Tick starts = 0;
  std::span<const BranchState> states;

  [[nodiscard]] Tick last_tick() const { return starts + static_cast<Tick>(states.size()) - 1; }
  // Before the first state: that one.
  [[nodiscard]] BranchState at(Tick tick, const Braking& braking) const {
    if (tick <= starts) return states.front();
    const std::uint64_t index = ticks_between(starts, tick);
    if (index < states.size()) return states[index];
    return after_last(states.back(), index - (states.size() - 1), braking);
  }
};

inline Path path_of(const Command& command) {
  return {command.starts, command.path()};
}

// Where a path is within a tick, `after_s` seconds from its begin, which is less than the period.
inline BranchState within_tick(const BranchState& from, const BranchState& next, double after_s,
                               double period_s) {
  const auto between = [share = after_s / period_s](const Velocity& a, const Velocity& b) {
    const Vector3 change = core::vector_of(b) - core::vector_of(a);
    return velocity_of(core::vector_of(a) + change * share);
  };
  const Velocity velocity = between(from.nominal.velocity, next.nominal.velocity);
  return {step_to(from.nominal, velocity, after_s), between(from.correction, next.correction)};
}

// The middle of the three points that hold all places of the tick that begins with this state (its
// Bezier control points); the others are its places at both ticks.
inline Point middle_of_tick(const Mover& from, double period_s) {
  const Vector3 half = core::vector_of(from.velocity) * (0.5 * period_s);
  return point_of(core::vector_of(from.position) + half);
}

// The far end of the segment that holds all places of the fallback from this state on.
inline Point latest_stop(const Mover& from, const Braking& braking) {
  const Vector3 way = braking.stopping_segment(core::vector_of(from.velocity));
  return point_of(core::vector_of(from.position) + way);
}

}  // namespace beespace::fleet
