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

// A row a pair in conflict, the worst first: how often, for how long in all, where it is closest,
// and for how long one of the two is unknown.
Rows pair_rows(const analysis::Findings& findings, const Distances& distances);

// To a row of each conflict: whether one of the two is not known just before it begins, or just
// after it ends. Nothing where all are known all the time.
void add_unknown_around(const analysis::Findings& findings, Rows& rows);

Rows separation_rows(const std::vector<analysis::Moment>& moments,
                     const analysis::Findings& findings, const Distances& distances);

}  // namespace beespace::cli
