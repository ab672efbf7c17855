#include "fleet/check_command.hpp"

#include "avoidance/validate.hpp"
#include "exact/validate.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace beespace::fleet {

namespace {

// How much may be lost where a number goes through a text or another type.
constexpr double kRounding = 1e-9;

// The most ticks in which an agent may come to a stop: each setpoint may have to count them.
constexpr double kMostBrakingTicks = 1e6;

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message), {}};
}

bool nearly_equal(double a, double b) {
  return std::abs(a - b) <= kRounding * (1.0 + std::abs(a) + std::abs(b));
}

template <class Three>
bool nearly_equal(const Three& a, const Three& b) {
  return nearly_equal(a.x, b.x) && nearly_equal(a.y, b.y) && nearly_equal(a.z, b.z);
}

// False for what is too large, infinite or not a number. Values may be small: a path is
// computed, not given.
template <class Three>
bool in_domain(const Three& a) {
  return std::abs(a.x) <= kLargestInMotion && std::abs(a.y) <= kLargestInMotion &&
         std::abs(a.z) <= kLargestInMotion;
}

bool in_domain(const BranchState& state) {
  return in_domain(state.nominal.position) && in_domain(state.nominal.velocity) &&
         in_domain(state.correction);
}

bool is_tick(Tick tick) {
  return tick >= -kLargestTick && tick <= kLargestTick;
}

bool is_number(BranchNumber number) {
  return epoch_of(number) != 0 && static_cast<std::uint32_t>(number) != 0;
}

// Descending, older than the command, and left no later than where its path ends.
bool can_be_ancestors(const Command& command) {
  BranchNumber newer = command.number;
  for (const Ancestor& ancestor : command.departs_from()) {
    if (!is_number(ancestor.number) || ancestor.number >= newer) return false;
    if (ancestor.departs > path_of(command).last_tick()) return false;
    newer = ancestor.number;
  }
  return true;
}

// Whether one state leads to the other in a tick.
bool leads_to(const Mover& from, const Mover& next, const Braking& braking) {
  const double change =
      core::length(core::vector_of(next.velocity) - core::vector_of(from.velocity));
  return change <= braking.change() + kRounding * (1.0 + braking.change()) &&
         nearly_same(step_to(from, next.velocity, braking.step_s()), next);
}

bool can_be_path(std::span<const BranchState> states, const FlightLimits& planned,
                 const Braking& braking) {
  const double fastest = planned.max_speed_mps + kRounding * (1.0 + planned.max_speed_mps);
  const auto is_state = [&](const BranchState& state) {
    return in_domain(state) && core::length(core::vector_of(state.nominal.velocity)) <= fastest;
  };
  if (!std::all_of(states.begin(), states.end(), is_state)) return false;
  const auto jumps = [&](const BranchState& from, const BranchState& next) {
    return !leads_to(from.nominal, next.nominal, braking);
  };
  return std::adjacent_find(states.begin(), states.end(), jumps) == states.end();
}

}  // namespace

std::optional<Error> check_planned(const FlightLimits& planned, double period_s) {
  if (auto error = avoidance::check_limits(planned)) return error;
  if (std::isinf(planned.max_acceleration_mps2)) {
    return invalid(
        "the greatest acceleration is infinite; give a finite one: an agent that loses its "
        "commands brakes with it");
  }
  if (!(period_s > 0.0) || !motion::in_motion_domain(period_s)) {
    return invalid("the period is " + core::shown(period_s) +
                   " s; give a finite time above zero (7.9e-31 s to 1.3e+30 s)");
  }
  const double change = planned.max_acceleration_mps2 * period_s;
  if (planned.max_speed_mps <= kMostBrakingTicks * change) return std::nullopt;
  return invalid("braking from " + core::shown(planned.max_speed_mps) + " m/s by " +
                 core::shown(change) +
                 " m/s each period takes more than 1000000 periods; give a greater acceleration, "
                 "a longer period or a lower speed");
}

bool nearly_same(const Mover& a, const Mover& b) {
  return nearly_equal(a.position, b.position) && nearly_equal(a.velocity, b.velocity);
}

bool can_be(const Command& command, const FlightLimits& planned, const Braking& braking) {
  if (command.state_count == 0 || command.state_count > Command::kMostStates) return false;
  if (command.ancestor_count > Command::kMostAncestors) return false;
  if (!is_number(command.number) || !is_tick(command.starts)) return false;
  if (!can_be_ancestors(command)) return false;
  return can_be_path(command.path(), planned, braking);
}

}  // namespace beespace::fleet
