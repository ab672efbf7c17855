/// @file
/// @brief Which points are closer than the threshold to any other point?
///
/// Point i is *at risk* when some other point j has |p_i - p_j| < threshold. The comparison is that
/// of real numbers on the given doubles: no rounding changes the answer, on any machine, with any
/// number of threads. Two points at the same position are at risk. The number of results is not
/// capped.
///
/// Source: the problem of "Robotic bees: Algorithms for collision detection and prevention", with
/// an exact answer also where the neighbour is two cells away.
#pragma once

#include <beespace/export.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <vector>

namespace beespace {

/// @brief Finds the points that are closer than the threshold to any other point.
///
/// Complexity: time and memory grow with the number of points, not with the space between them.
/// Beyond the input at most 48 bytes a point while it runs, and up to 48 more where the points
/// spread over more than 2^24 thresholds along an axis.
///
/// Thread safety: no state is kept; any number of threads may call it at the same time.
///
/// @param points The positions in metres; read in place, not kept.
/// @param options The threshold and how to search; SearchOptions::threshold_m must be given.
/// @return The ids of the points at risk, ascending; or an error:
///   - ErrorCode::kInvalidThreshold: a threshold that is not given, not finite, not above zero or
///     outside the coordinate domain;
///   - ErrorCode::kInvalidArgument: a view whose arrays differ in length, or another option that
///     makes no sense;
///   - ErrorCode::kTooManyPoints: more than #kMaxPoints;
///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a coordinate that is not a number of the
///     coordinate domain (see Point), with the first such point in ErrorLocation::record;
///   - ErrorCode::kStopped: a stop was requested (SearchOptions::stop).
BEESPACE_API Result<std::vector<PointId>> find_at_risk(const PointsView& points,
                                                       const SearchOptions& options);

/// @brief Finds the points of one set that are closer than the threshold to any point of another
/// set: two swarms, or a swarm and fixed points. Points of the same set do not count.
///
/// Complexity and thread safety: as find_at_risk.
///
/// @param points The positions in metres of which ids are returned.
/// @param others The positions in metres of the other set.
/// @param options The threshold and how to search.
/// @return The ids of those `points` that are at risk, ascending; or an error as find_at_risk. An
///   error about `others` names them in ErrorLocation::array.
BEESPACE_API Result<std::vector<PointId>> find_at_risk_between(const PointsView& points,
                                                               const PointsView& others,
                                                               const SearchOptions& options);

}  // namespace beespace
