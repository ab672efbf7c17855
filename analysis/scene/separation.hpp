// How far apart those are that are closest, over time.
#pragma once

#include "analysis/recorded/findings.hpp"
#include "analysis/scene/uprights.hpp"
#include "report/facts.hpp"

#include <vector>

namespace beespace::analysis {

struct SeparationOverTime {
  std::vector<report::Separation> known;
  std::vector<TimeSpan> open;  // ascending, none touch
};

// At some hundred moments, but for those at which one would be closer on a straight line across its
// gap, which are open, and where the closest encounter was. Open are also the times of `unknown` at
// which no two are known; of a show, which plans the flights of all, all of them. With a vertical
// threshold
// (`vertical_m` of `swarm`), of those who are nearest to a conflict.
SeparationOverTime separation_of(const Findings& findings, const Uprights& uprights,
                                 const std::vector<Gap>& unknown, const report::SwarmFacts& swarm);

}  // namespace beespace::analysis
