// What the planner of a fleet said of each bee: where it shall be, how far from there it can be,
// whether it keeps its contract, and on which branches it may be (docs/prevention.md).
#pragma once

#include <beespace/command.hpp>
#include <beespace/guide.hpp>
#include <beespace/point.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::report {

// A branch, by what it has of its own: until `at` it goes along the one that it departs from, and
// then straight on to a stop.
struct FleetBranch {
  Tick at = 0;
  Point place;             // there and then
  Point stop;              // where it stands at last,
  double braking_s = 0.0;  // so long after that tick, or at the end of that period
  std::optional<std::uint32_t> parent = {};  // by its place in the list of its bee; none: not known
};

// A tick. The bee may be on `branches` branches: on `newest`, its parent, the parent of that, ...
struct FleetState {
  Tick tick = 0;
  Point nominal;
  double tube_m = 0.0;
  Contract contract = Contract::kKept;
  ContractReason reason = ContractReason::kNone;
  bool certified = false;
  std::uint32_t branches = 0;
  std::optional<std::uint32_t> newest = {};  // by its place in the list; none: it is not known
};

struct FleetBee {
  std::vector<FleetState> states = {};  // of ascending ticks
  std::vector<FleetBranch> branches = {};
};

struct FleetFacts {
  std::string title;           // the file's name
  double period_s = 0.0;       // a tick; tick 0 is at time 0 of the recording
  std::vector<FleetBee> bees;  // one for each of the recording
};

}  // namespace beespace::report
