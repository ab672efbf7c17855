// Who is closer than the threshold to anybody else?
//
// Point i is at risk when some other point j has |p_i - p_j| < threshold. The comparison is the
// one of real numbers on the given doubles: no rounding changes the answer, on any machine, with
// any number of threads. Two points at the same place are at risk. Nothing is capped.
//
// Source: the problem of "Robotic bees: Algorithms for collision detection and prevention", with
// an exact answer also where the neighbour is two cells away.
#pragma once

#include <beespace/export.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <vector>

namespace beespace {

// The ids of the points at risk, ascending.
//
// Cost: time and memory grow with the number of points, not with the space between them. Beyond the
// input at most 48 bytes a point while it runs, and up to 72 more where the points spread over more
// than 2^20 thresholds along an axis. Thread-safe: no state is kept.
// Errors: kInvalidThreshold, kTooManyPoints; kNotFinite and kOutsideDomain with the first such
// point in place.record.
BEESPACE_API Result<std::vector<PointId>> find_at_risk(const PointsView& points,
                                                       const SearchOptions& options);

// The ids of those `points` that are closer than the threshold to any of `others`, ascending: our
// swarm against theirs, or against fixed obstacles. Points of the same set do not count. Costs and
// errors as above; an error about `others` names them in place.source.
BEESPACE_API Result<std::vector<PointId>> find_at_risk_between(const PointsView& points,
                                                               const PointsView& others,
                                                               const SearchOptions& options);

}  // namespace beespace
