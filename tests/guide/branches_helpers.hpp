// Branches of one agent, for tests.
#pragma once

#include "guide/branches.hpp"

#include <vector>

namespace beespace::guide {

inline constexpr AgentId kAgent = 7;
inline constexpr FlightLimits kPlanned{.max_speed_mps = 8.0, .max_acceleration_mps2 = 2.0};
inline constexpr double kPeriod_s = 0.5;  // a metre per second each tick
inline constexpr Point kPlace = {1, 2, 3};
inline constexpr Tick kLast = std::numeric_limits<Tick>::max();

inline BranchOptions options(int delay = 2) {
  return {.agent = kAgent, .planned = kPlanned, .period_s = kPeriod_s, .command_delay = delay};
}

inline BranchNumber number(std::uint32_t count, std::uint32_t epoch = 1) {
  return branch_number(epoch, count);
}

inline Acknowledgement taken(BranchNumber of) {
  return {kAgent, of, CommandReply::kTaken, of, 0};
}

// The base, changed by this.
inline Velocity changed(const Branches& branches, double by_mps) {
  Velocity velocity = branches.base_state(branches.departs()).velocity;
  velocity.x += by_mps;
  return velocity;
}

inline Command issue(Branches& branches, double by_mps = 0.5) {
  Command command;
  branches.issue(changed(branches, by_mps), {}, command);
  return command;
}

inline std::vector<Point> places_from(const Branches& branches, Tick from) {
  std::vector<Point> places;
  branches.append_places(from, places);
  return places;
}

}  // namespace beespace::guide
