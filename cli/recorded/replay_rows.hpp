// What was found in a recording as rows of `replay`: bee by bee, pair by pair, or moment by moment.
#pragma once

#include "analysis/recorded/findings.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/rows.hpp"

#include <vector>

namespace beespace::cli {

// A row a bee: its id, its conflicts, how long it was in conflict (with however many at a time),
// how close it came to another one in a conflict, or in a show whether conflict or not, and to
// which; and how long it is unknown.
Rows bee_rows(const analysis::Findings& findings, const Distances& distances);

// A row a pair in conflict, the closest first: how often, for how long in all, and where it is
// closest.
Rows pair_rows(const analysis::Findings& findings, const Distances& distances);

Rows separation_rows(const std::vector<analysis::Moment>& moments,
                     const analysis::Findings& findings, const Distances& distances);

}  // namespace beespace::cli
