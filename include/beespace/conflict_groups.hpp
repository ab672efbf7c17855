// Which bees must be looked at together to bring them apart?
//
// A conflict group is a connected component of "closer than the threshold": from every member one
// gets to every other by steps shorter than the threshold, and to nobody else. Moving a bee can
// only make trouble within its own group, or create a new conflict.
#pragma once

#include <beespace/export.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

namespace beespace {

// Each row is a group: its members' ids, ascending. Groups stand in the order of their lowest
// member; points that are not at risk are in no group.
//
// Cost: as find_pairs, but crowds are joined cell by cell: a million points at one place cost no
// more than a million elsewhere. Errors: as find_at_risk.
BEESPACE_API Result<IdRows> find_conflict_groups(const PointsView& points,
                                                 const SearchOptions& options);

}  // namespace beespace
