// A model of one planner, one agent and the channel between them, of which all interleavings are
// tried.
//
// What was once said can be heard at any later time, any number of times, or never: so the channel
// loses, delays, doubles and reorders, and its state is the set of what was said. The agent's clock
// may be off by a tick. Agent and planner may start anew. The agent is a Follower, the planner a
// Branches, as they are; faults are put in around them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace beespace::test {

enum class Fault : std::uint8_t {
  kNone,
  // Rules of the planner.
  kClockDrops,         // a command that has taken effect by the clock is taken for taken
  kTakenDropsNewer,    // an acknowledgement drops newer branches
  kLateReportIsOfNow,  // a report is taken for one of now
  kRefusalDrops,       // a refusal drops what was refused
  kNoAncestorTicks,    // all ancestors are listed with the departure from the base
  // Rules of the agent.
  kTakesAtDeparture,  // tick <= departs
  kStoresLate,        // acknowledgements are sent before the branch is stored
  kTakesAtOnce,       // commands are taken as soon as it has started anew
  kRootsStay,         // a root is taken however old it is
  // Rules of both, when a planner starts anew.
  kAdoptsUnpromised,  // a branch is adopted that the agent may still leave for an old command
  kAdoptsOldAnswer,   // the answer to the planner before counts
  kForgetsPromise,    // promises are not stored
};

struct ModelBounds {
  int command_delay = 1;
  int commands = 3;  // besides roots
  int ticks = 3;
  bool clock_is_off = false;  // by up to a tick
  bool knows_root = true;     // whether the agent is on its root from the beginning
  int agent_starts = 0;       // how often it starts anew
  int planner_starts = 0;
  int losses = 0;   // how often the agent loses its branch
  int rejoins = 0;  // how often it leaves, forgets all, and joins the same planner
};

struct ModelResult {
  std::size_t states = 0;
  std::size_t events = 0;
  std::size_t most_live = 0;
  std::size_t taken = 0;       // commands, in all events
  std::string violation = {};  // empty: none; else what went wrong, and the events up to there
};

// Ends at the first violation.
ModelResult check_model(const ModelBounds& bounds, Fault fault = Fault::kNone);

}  // namespace beespace::test
