// How crowded is it, seen from a random point? Estimated from a sample, in a fraction of a
// millisecond, and right for clustered points too, where an average over space says nothing.
#pragma once

#include <beespace/points_view.hpp>

namespace beespace::core {

// The expected number of other points in a point's own cell, for cubic cells of side `cell_m`:
// the share of pairs of a sample of 4,096 points that share a cell, times the number of points.
// Deterministic. Sees a tenth of a mate among a million points as plain zero.
double mean_cell_mates(const PointsView& points, double cell_m);

}  // namespace beespace::core
