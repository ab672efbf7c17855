// Who is closer than the threshold to each point, and how many are they?
//
// Compared as real numbers, as in at_risk.hpp. Nothing is capped.
#pragma once

#include <beespace/export.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <vector>

namespace beespace {

// Row i holds the ids of the other points closer than the threshold to point i, ascending.
//
// Cost: some tens of nanoseconds a point, and about ten a neighbour. Memory: 48 bytes a point, and
// 12 a neighbour. Errors: as find_at_risk; kTooManyResults when all rows together hold more than
// options.max_results.
BEESPACE_API Result<IdRows> find_neighbors(const PointsView& points, const SearchOptions& options);

// Row i holds the ids of those `others` that are closer than the threshold to points[i].
BEESPACE_API Result<IdRows> find_neighbors_between(const PointsView& points,
                                                   const PointsView& others,
                                                   const SearchOptions& options);

// How many other points are closer than the threshold to each point: the lengths of the rows above,
// without the rows. Memory: 44 bytes a point. Errors: as find_at_risk.
BEESPACE_API Result<std::vector<std::uint32_t>> count_neighbors(const PointsView& points,
                                                                const SearchOptions& options);

BEESPACE_API Result<std::vector<std::uint32_t>> count_neighbors_between(
    const PointsView& points, const PointsView& others, const SearchOptions& options);

}  // namespace beespace
