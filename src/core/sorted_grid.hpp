// Points in the order of their cells: the structure that every search walks.
//
//   row   all points whose cells share y and z; its points stand together, in order of their cell
//         along x. Rows stand in order of (z, y). Only occupied rows exist.
//
//        y+1  [ . . . ]      A point's neighbours within the reach lie in its own and the 8
//        y    [ . p . ]      surrounding rows, three cells wide: nine short runs of memory.
//        y-1  [ . . . ]      (Here is one layer z of the three.)
//
// Coordinates are kept as fixed-point units of the lattice, 4 bytes an axis: as precise beside an
// outlier 10^12 reaches away as without it.
#pragma once

#include <beespace/crew.hpp>
#include "core/buffer.hpp"
#include "core/lattice.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace beespace::core {

// Kernels read whole vectors: this many elements behind the last point may be read.
inline constexpr std::size_t kPadding = 16;

struct SortedGrid {
  std::size_t size = 0;
  const std::int32_t* x = nullptr;  // lattice positions, below 2^30
  const std::int32_t* y = nullptr;
  const std::int32_t* z = nullptr;
  const PointId* id = nullptr;  // in the caller's numbering
  unsigned fraction_bits = 0;
  double units_per_m = 0.0;

  // Row r holds the points [row_begin[r], row_begin[r + 1]); its number is row_number[r].
  std::vector<std::uint32_t> row_begin;
  std::vector<std::uint64_t> row_number;  // ascending: z * rows_a_layer + y
  std::uint64_t rows_a_layer = 0;

  Buffer<std::int32_t> storage;  // of the four arrays

  [[nodiscard]] std::size_t rows() const { return row_number.size(); }

  // The first row at or after `from` whose number is at least `number`.
  [[nodiscard]] std::size_t skip_to(std::uint64_t number, std::size_t from) const {
    while (from < rows() && row_number[from] < number) ++from;
    return from;
  }
};

// All points, or those of `subset` if it is not empty. Working memory: 32 bytes a point and 12 an
// occupied row, of which the grid keeps 16 and 12.
SortedGrid sort_into_grid(const PointsView& points, std::span<const PointId> subset,
                          const Lattice& lattice, Crew& crew);

}  // namespace beespace::core
