// The two closest points of all.
//
//   an eighth of the points, in short runs  --(same again)-->  their closest pair: a bound
//   all points  --occupancy filter: a neighbour within the bound?-->  few
//   those few, sorted into a grid as fine as the bound  -->  the closest pair, exactly
//
// Source: the sieve of S. Khuller and Y. Matias, A simple randomized sieve algorithm for the
// closest-pair problem, 1995; the bound from a sample is M. O. Rabin's, 1976. Expected cost and
// memory are proportional to the number of points, for any points.
#pragma once

#include "base/bounds.hpp"
#include "base/resources.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

namespace beespace::core {

struct IdPair {
  PointId first;
  PointId second;
};

// first < second; of equally close pairs the one with the lowest first id, then second. Needs at
// least two points, all valid and within `bounds`.
IdPair closest_pair(const PointsView& points, const Bounds& bounds, const Resources& with);

}  // namespace beespace::core
