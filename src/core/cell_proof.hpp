// The cheapest proof of all: two points in a cell whose diagonal is below the threshold are closer
// than the threshold, with no distance computed.
//
// In a crowd this settles nearly every point in two passes over the data. The rest is left to the
// search proper.
#pragma once

#include "core/bounds.hpp"
#include "core/buffer.hpp"
#include "core/crew.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::core {

// The side of cubes whose diagonal is the threshold.
double proof_cell_side(double threshold);

// How cells are counted: in a plain table where the box has few enough of them, else by hashing.
enum class CellTable : std::uint8_t { kAutomatic, kDense, kHashed };

struct CellProof {
  std::vector<PointId> alone;  // the points without company in their cell, ascending

  // Every point that may be within the threshold of one of those, themselves included; ascending.
  // Absent where finding out was not cheap: then all points may be.
  std::optional<std::vector<PointId>> around;
};

// Sets at_risk[id] to 1 for every point that has company in its cell, to 0 for the others. `table`
// is forced in tests only; a dense table that would not fit is not used. Working memory: at most
// 8 bytes a point (dense), 36 (hashed).
CellProof prove_by_cells(const PointsView& points, const Bounds& bounds, double threshold,
                         Crew& crew, Buffer<std::uint8_t>& at_risk,
                         CellTable table = CellTable::kAutomatic);

}  // namespace beespace::core
