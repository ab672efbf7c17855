// The cheapest proof of all: two points in a cell whose diagonal is below the threshold are closer
// than the threshold, with no distance computed.
//
// In a crowd this settles nearly every point in two passes over the data. If few points are left,
// they are compared with the points of the cells around theirs; if many, the search proper decides
// them.
#pragma once

#include "base/bounds.hpp"
#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "exact/exact_distance.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <cstdint>

namespace beespace::core {

// The side of cubes whose diagonal is the threshold.
double proof_cell_side(double threshold);

// How cells are counted: in a plain table where the box has few enough of them, else by hashing.
enum class CellTable : std::uint8_t { kAutomatic, kDense, kHashed };

// Sets at_risk[id] to 1 for every point that shares its cell. If few are left and the table is
// dense, they are decided too, from the points of the cells around theirs. Returns the points that
// are still undecided, ascending, with at_risk[id] == 0; `closer` is the test for `threshold`.
// `table` is forced in tests only; a dense table that would not fit is not used. Working memory: at
// most 28 bytes a point (dense), 17 (hashed).
Vector<PointId> prove_by_cells(const PointsView& points, const Bounds& bounds, double threshold,
                               const ProximityTest& closer, const Resources& with,
                               Buffer<std::uint8_t>& at_risk,
                               CellTable table = CellTable::kAutomatic);

}  // namespace beespace::core
