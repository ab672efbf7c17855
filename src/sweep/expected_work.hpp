// How much work a sweep would be, before it is begun.
#pragma once

#include "sweep/row_sweeps.hpp"

namespace beespace::cpu {

// About how many pairs a sweep of all rows around would compare, from some dozens of query points.
// What a tenth of them see shows. Cost: some hundred microseconds at most.
double expected_comparisons(const SweepQuery& question);

// The same where a query point is left once it has a near one, and what floats leave open counts
// for as many as take that long. Cost: up to some milliseconds.
double expected_comparisons_until_near(const SweepQuery& question);

}  // namespace beespace::cpu
