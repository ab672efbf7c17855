// The search behind find_nearest and its relatives, with its tuning open to tests and benchmarks.
//
// All points are searched around within a radius in which most find another; then, again and again,
// those that have not found their nearest, within a larger one. Where that would be too much work,
// because densities differ too much or the others are far away, a tree of boxes is asked.
#pragma once

#include "base/resources.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/nearest.hpp>
#include <beespace/search_options.hpp>

#include <optional>
#include <vector>

namespace beespace::search {

// For each of the domain's points its nearest other, or its nearest of the domain's others; within
// the options' threshold if there are options.
void find_nearest(const SearchDomain& domain, const std::optional<PairOptions>& within,
                  const core::Resources& with, const TuningOverrides& tuning,
                  std::vector<Nearest>& nearest);

// The closest of all pairs of one of the domain's points and one of its others.
// `nearest` is working memory.
std::optional<ClosestPair> find_closest_between(const SearchDomain& domain,
                                                const core::Resources& with,
                                                const TuningOverrides& tuning,
                                                std::vector<Nearest>& nearest);

}  // namespace beespace::search
