// Nearest others by a tree of boxes: for what a grid of one cell size would compare too often, or
// look for in too many grids.
#pragma once

#include "base/resources.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/nearest.hpp>
#include <beespace/search_options.hpp>

#include <optional>
#include <span>
#include <vector>

namespace beespace::search {

// Writes to nearest[id] the nearest of the domain's others, within the options' threshold if there
// are options, for each of its points in `asked`, and maybe for others; an empty span: for all.
// There must be another point.
//
// Cost: of sorting into trees, and of the boxes that the ball around each point up to its nearest
// touches. How many these are in the worst layouts is said in docs/how-it-works.md.
void find_nearest_in_tree(const SearchDomain& domain, std::span<const PointId> asked,
                          const std::optional<PairOptions>& within, const core::Resources& with,
                          const TuningOverrides& tuning, std::vector<Nearest>& nearest);

}  // namespace beespace::search
