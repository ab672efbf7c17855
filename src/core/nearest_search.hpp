// The nearest other point of every point, within a threshold.
//
// Duplicates find each other by hashing. The others look within a small radius first, and those who
// found nobody look farther: in a crowd the nearest is near, whatever the threshold. Every round
// sorts the points that may matter into a grid as fine as its radius, and asks for those that are
// still open only, so a clump beside open country costs no more than either.
#pragma once

#include <beespace/crew.hpp>
#include "core/bounds.hpp"

#include <beespace/nearest.hpp>
#include <beespace/points_view.hpp>
#include <beespace/search_options.hpp>

#include <vector>

namespace beespace::core {

// `points` and `options` must be valid and `bounds` those of the points.
std::vector<Nearest> nearest_within(const PointsView& points, const Bounds& bounds,
                                    const SearchOptions& options, Crew& crew);

}  // namespace beespace::core
