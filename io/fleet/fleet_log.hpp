// What a planner said to a fleet and of it, kept: lines as `beespace guide` writes them. Of these
// "status" and "command" are read, the others are passed over. See docs/fleet-messages.md.
#pragma once

#include "io/bytes/progress.hpp"

#include <beespace/command.hpp>
#include <beespace/guide.hpp>
#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// A command. After its last state the agent brakes, until it stands.
struct LoggedBranch {
  BranchNumber number = 0;
  BranchNumber parent = 0;  // the newest one that it departs from; 0: none
  Tick starts = 0;
  std::vector<Mover> states;  // at that tick and each one after it; one or more
  double braking_mps2 = 0.0;
};

// A status.
struct LoggedStatus {
  Tick tick = 0;
  AgentGuidance told;
  std::size_t sent = 0;  // how many of the agent's branches were sent before
};

struct LoggedAgent {
  std::string id;
  std::uint64_t line = 0;              // of the first that is about it
  std::vector<LoggedStatus> statuses;  // of ascending ticks
  std::vector<LoggedBranch> branches;  // each once, in the order in which they were sent
};

struct FleetLog {
  std::string source;
  double period_s = 0.0;  // a tick; tick 0 is at time 0
  std::vector<LoggedAgent> agents;
  std::uint64_t skipped = 0;  // bad lines that were left out
};

// With `skip_bad` a line that is wrong is left out. Errors: those of opening and unpacking; a line
// that is wrong, with its number; kNoPoints where nothing is said of any agent; kMissingColumn
// where the log holds no command, or tells of agents only when something changes.
Result<FleetLog> load_fleet_log(const std::string& path, bool skip_bad, Progress* progress);
// The same of what was read already; `source` is what errors blame.
Result<FleetLog> read_fleet_log(std::string_view content, std::string source, bool skip_bad);

}  // namespace beespace::io
