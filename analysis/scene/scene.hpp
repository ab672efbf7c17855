// What there is to see of an input, ready to be drawn, exported, or put into a page.
#pragma once

#include "report/facts.hpp"

#include <string>
#include <variant>

namespace beespace::analysis {

using Scene = std::variant<report::SnapshotFacts, report::RecordingFacts>;

const report::SwarmFacts& swarm_of(const Scene& scene);
report::SwarmFacts& swarm_of(Scene& scene);

// Whether a bee is at risk, or may be in a gap; or will be, as far as a snapshot is looked ahead
// of.
bool is_risky(const Scene& scene);

void set_title(Scene& scene, const std::string& title);

}  // namespace beespace::analysis
