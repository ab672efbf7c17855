/// @file
/// @brief Which points are closer than the threshold to each point, and how many are they?
///
/// Compared as real numbers, as in at_risk.hpp. The number of results is not capped.
#pragma once

#include <beespace/export.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <vector>

namespace beespace {

/// @brief Finds the neighbours of each point: the other points closer than the threshold.
///
/// Complexity: some tens of nanoseconds a point, and about ten a neighbour. Memory: 48 bytes a
/// point, and 12 a neighbour. Thread safety: no state is kept.
///
/// @param points The positions in metres; read in place, not kept.
/// @param options The threshold and how to search.
/// @return Row i holds the ids of the neighbours of point i, ascending; or an error as
/// find_at_risk,
///   and ErrorCode::kTooManyResults when all rows together hold more than
///   PairOptions::max_results.
BEESPACE_API Result<IdRows> find_neighbors(const PointsView& points, const PairOptions& options);

/// @brief Finds the neighbours of each point of one set among the points of another.
///
/// Complexity and thread safety: as find_neighbors.
///
/// @param points The positions in metres, each of which has a row.
/// @param others The positions in metres of the other set.
/// @param options The threshold and how to search.
/// @return Row i holds the ids of those `others` that are closer than the threshold to points[i],
///   ascending; or an error as find_neighbors.
BEESPACE_API Result<IdRows> find_neighbors_between(const PointsView& points,
                                                   const PointsView& others,
                                                   const PairOptions& options);

/// @brief Counts the neighbours of each point: the lengths of the rows of find_neighbors, without
/// the rows.
///
/// Memory: 44 bytes a point. Thread safety: no state is kept.
///
/// @param points The positions in metres; read in place, not kept.
/// @param options The threshold and how to search.
/// @return Entry i is the number of neighbours of point i; or an error as find_at_risk.
BEESPACE_API Result<std::vector<std::uint32_t>> count_neighbors(const PointsView& points,
                                                                const SearchOptions& options);

/// @brief Counts the neighbours of each point of one set among the points of another.
/// @param points The positions in metres, each of which has a count.
/// @param others The positions in metres of the other set.
/// @param options The threshold and how to search.
/// @return Entry i is the number of those `others` that are closer than the threshold to points[i];
///   or an error as find_at_risk_between.
BEESPACE_API Result<std::vector<std::uint32_t>> count_neighbors_between(
    const PointsView& points, const PointsView& others, const SearchOptions& options);

}  // namespace beespace
