/// @file
/// @brief Which points must be considered together to separate them?
///
/// A conflict group is a connected component of the relation "closer than the threshold": steps
/// shorter than the threshold lead from each member to each other member, and to no other point.
/// Moving a point affects only its own group, or creates a new conflict.
#pragma once

#include <beespace/export.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

namespace beespace {

/// @brief Finds the connected components of "closer than the threshold".
///
/// Complexity: as find_pairs, but crowds are joined cell by cell: a million points at one position
/// cost no more than a million elsewhere. Thread safety: no state is kept.
///
/// @param points The positions in metres; read in place, not kept.
/// @param options The threshold and how to search.
/// @return Each row is a group: the ids of its members, ascending. Groups stand in the order of
///   their lowest member; points that are not at risk are in no group. Or an error as find_at_risk.
BEESPACE_API Result<IdRows> find_conflict_groups(const PointsView& points,
                                                 const SearchOptions& options);

}  // namespace beespace
