// Leaves out points that surely have no neighbour, at the cost of a few table look-ups a point.
//
// Source: the sieve of S. Khuller and Y. Matias, A simple randomized sieve algorithm for the
// closest-pair problem, 1995.
#pragma once

#include "base/resources.hpp"
#include "grid/lattice.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

namespace beespace::core {

// The points that may have another point within `bound`, ascending: all that have, and some that
// have not. The lattice's cells should be some times as wide as the bound (then few points are near
// a face of theirs) and mostly empty. Working memory: at most 8 bytes a point, and those left.
Vector<PointId> occupancy_filter(const PointsView& points, const Lattice& lattice, double bound,
                                 const Resources& with);

}  // namespace beespace::core
