// From files to what there is to see of them: a snapshot or a recording, whichever they hold.
#pragma once

#include "cli/console/progress_bar.hpp"
#include "cli/show/seen_request.hpp"
#include "report/facts.hpp"

#include <beespace/result.hpp>

#include <string>
#include <variant>
#include <vector>

namespace beespace::cli {

using Seen = std::variant<report::SnapshotFacts, report::RecordingFacts>;

const report::SwarmFacts& swarm_of(const Seen& seen);
// Whether somebody is at risk, or may be in a gap.
bool is_risky(const Seen& seen);
void set_title(Seen& seen, const std::string& title);

// How long each part took, of all that is seen.
struct SeenTimings {
  double read_s = 0.0;
  double find_s = 0.0;
  double write_s = 0.0;  // making what is written, too
};

// One file may hold a snapshot; a folder or several files are one recording, and so is a table with
// more than one time in it, also where each bee has one fix. Aircraft that are each
// at one instant are brought to the last of them, as by `beespace predict`. Errors: those of
// reading and searching. Adds to `timings` how long it reads and finds.
Result<Seen> see(const std::vector<std::string>& inputs, const SeenRequest& request,
                 ProgressBar& progress, SeenTimings& timings);

}  // namespace beespace::cli
