// Points in the order of their rows and slices (see cell_order.hpp): the structure that every
// search walks. Coordinates are kept as fixed-point positions of the lattice, 4 bytes an axis: as
// precise beside an outlier 10^12 reaches away as without it.
#pragma once

#include "base/buffer.hpp"
#include "base/point_block.hpp"
#include "base/resources.hpp"
#include "grid/lattice.hpp"

#include <beespace/point.hpp>

#include <cstdint>

namespace beespace::core {

// Kernels read whole vectors: this many elements behind the last point may be read.
inline constexpr std::size_t kPadding = 16;

struct SortedGrid {
  explicit SortedGrid(Memory& memory) : row_begin(&memory), row_number(&memory) {}

  std::size_t size = 0;
  std::int32_t* x = nullptr;  // lattice positions, below 2^30
  std::int32_t* y = nullptr;
  std::int32_t* z = nullptr;
  PointId* id = nullptr;  // in the caller's numbering

  unsigned fraction_bits = 0;  // a cell is 1 << fraction_bits units wide,
  unsigned row_shift = 0;      // a row 1 << row_shift cells,
  unsigned slice_bits = 0;     // a slice 1 << slice_bits units
  double units_per_m = 0.0;

  // Row r holds the points [row_begin[r], row_begin[r + 1]); its number is row_number[r]. Only
  // rows that hold points exist.
  Vector<std::uint32_t> row_begin;
  Vector<std::uint64_t> row_number;  // ascending: z * rows_a_layer + y + 1
  std::uint64_t rows_a_layer = 0;

  Buffer<std::int32_t> storage;  // of the four arrays

  [[nodiscard]] std::size_t rows() const { return row_number.size(); }

  // The first row at or after `from` whose number is at least `number`.
  [[nodiscard]] std::size_t skip_to(std::uint64_t number, std::size_t from) const {
    while (from < rows() && row_number[from] < number) ++from;
    return from;
  }
};

// Cost: two looks at every point, one scatter of 16 bytes, and passes over a few hundred points at
// a time in the nearest cache. Working memory: 32 bytes a point and 12 a row that holds points, of
// which the grid keeps 16 and 12.
SortedGrid sort_into_grid(const Selection& selected, const Lattice& lattice, unsigned row_shift,
                          const Resources& with);

}  // namespace beespace::core
