// The two closest points of all.
//
//   one point in 32, in short runs  --(same again)-->  their closest pair: a bound
//   all pairs of points within the bound, which are few  -->  the closest of them, exactly
//
// Source: the bound from a sample is M. O. Rabin's, Probabilistic algorithms, 1976. Expected cost
// and memory are proportional to the number of points, for any points.
#pragma once

#include "base/resources.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/pairs.hpp>

namespace beespace::search {

// Of equally close pairs the one with the lowest first id, then second. Of a domain without others
// that has at least two points.
Pair find_closest_pair(const SearchDomain& domain, const core::Resources& with,
                       const TuningOverrides& tuning);

}  // namespace beespace::search
