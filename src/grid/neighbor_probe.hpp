// Queries for a few points among many: is any other point within the threshold of this one?
//
// Cost: for each query point, nine short runs of the grid, left at the first hit. In a crowd that
// cell_proof has processed, at most 343 points of any 3 x 3 x 3 cells are query points (each has
// its own smaller cell), so the whole stays proportional to the number of points.
#pragma once

#include "base/bounds.hpp"
#include "base/point_block.hpp"
#include "base/resources.hpp"
#include "exact/exact_distance.hpp"
#include "grid/lattice.hpp"
#include "grid/sorted_grid.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <cstdint>

namespace beespace::core {

// Those of `others` that may be within the lattice's reach of one of `asked`, ascending. A
// superset: cells are remembered by their hashes.
Vector<PointId> surroundings(const Selection& asked, const Selection& others,
                             const Lattice& lattice, const Resources& with);

// Sets at_risk[id] to 1 for the points of the grid with at_risk[id] == 0 that have another point
// of the grid within `threshold`, which is at most the reach of the grid's lattice.
void probe_neighbors(const SortedGrid& grid, const PointsView& points, const ProximityTest& closer,
                     double threshold, const Resources& with, std::uint8_t* at_risk);

}  // namespace beespace::core
