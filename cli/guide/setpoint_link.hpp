// Agents that know no commands, only where to be now: autopilots behind a MAVLink radio. A follower
// for each takes its commands here, and tells them setpoint after setpoint.
#pragma once

#include "cli/guide/guided_fleet.hpp"

#include <beespace/follower.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace beespace::cli {

class SetpointLink {
 public:
  // `velocity_only`: the loop is closed on the ground.
  SetpointLink(double period_s, bool velocity_only)
      : period_s_(period_s), velocity_only_(velocity_only) {}

  // Errors: an id that is no system of MAVLink.
  static Status check(std::string_view id);

  // Who has left has no follower any more. What an agent measured becomes its report.
  Status take(const io::FleetMessage& message, GuidedFleet& fleet, std::string& lines);
  // Before and after the step of the fleet.
  void advance(Tick now);
  Status tell(Tick now, GuidedFleet& fleet, std::string& lines, std::string& frames);

 private:
  struct Agent {
    Follower follower;
    std::uint8_t system = 0;
  };

  Status take_commands(Tick now, GuidedFleet& fleet, std::string& lines);

  double period_s_;
  bool velocity_only_;
  std::map<std::string, Agent, std::less<>> agents_;
  std::uint8_t sequence_ = 0;
};

}  // namespace beespace::cli
