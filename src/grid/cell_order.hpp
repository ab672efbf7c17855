// The order of points in a grid, and its rows.
//
// Space is cut into long square bars along x, called rows: `1 << row_shift` cells wide in y and z.
// Points stand in the order of their rows, within a row in the order of slices along x, a quarter
// of a cell thin, and within a slice in any order.
//
//   z  +-------+-------+     Points within the reach of p are in its own row, or, where p's cell
//      | .   . |   .   |     is at the edge of its row, in the row beyond that edge; and there at
//      |     p |.  .   |     most a cell away along x. Wide rows suit thin swarms: most points need
//      +-------+-------+     to look at their own row only.
//      |  .    | .     |
//      +-------+-------+ y
#pragma once

#include "grid/lattice.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace beespace::core {

// A point on its way into a grid. Its lattice positions tell its place, so no key is carried.
struct CellRecord {
  std::array<std::int32_t, 3> position;
  PointId id;
};

class CellOrder {
 public:
  CellOrder(const Lattice& lattice, unsigned row_shift)
      : row_bits_(lattice.fraction_bits() + row_shift),
        slice_bits_(lattice.fraction_bits() - std::min(lattice.fraction_bits(), kFineBits)),
        rows_a_layer_(rows_across(lattice, 1, row_shift) + 2),
        rows_(rows_a_layer_ * rows_across(lattice, 2, row_shift)),
        x_key_bits_(bits_for((lattice.cells(0) << lattice.fraction_bits()) >> slice_bits_)),
        row_key_bits_(bits_for(rows_)) {}

  // Row numbers leave a row empty before and behind those of a layer, so that one less and one
  // more never name a row of another layer.
  [[nodiscard]] std::uint64_t row(std::int32_t y, std::int32_t z) const {
    // Of 32 bits each, which is one instruction for several points even where there is none for 64.
    const std::uint64_t layer = static_cast<std::uint32_t>(z) >> row_bits_;
    return layer * static_cast<std::uint32_t>(rows_a_layer_) +
           (static_cast<std::uint32_t>(y) >> row_bits_) + 1;
  }
  [[nodiscard]] std::uint64_t row(const CellRecord& record) const {
    return row(record.position[1], record.position[2]);
  }
  [[nodiscard]] std::uint64_t rows_a_layer() const { return rows_a_layer_; }

  // Positions along x that differ from this bit upward are in different slices.
  [[nodiscard]] unsigned slice_bits() const { return slice_bits_; }

  [[nodiscard]] unsigned x_key_bits() const { return x_key_bits_; }
  [[nodiscard]] unsigned key_bits() const { return x_key_bits_ + row_key_bits_; }
  // The place in the order from bit `shift` upward: the slice in the low bits, the row above. Keys
  // may have more than 64 bits; those beyond are cut off.
  [[nodiscard]] std::uint64_t key(std::int32_t x, std::int32_t y, std::int32_t z,
                                  unsigned shift) const {
    if (shift >= x_key_bits_) return row(y, z) >> (shift - x_key_bits_);
    const std::uint64_t slice = static_cast<std::uint32_t>(x) >> slice_bits_;
    return slice >> shift | row(y, z) << (x_key_bits_ - shift);
  }
  [[nodiscard]] std::uint64_t key(const CellRecord& record, unsigned shift) const {
    return key(record.position[0], record.position[1], record.position[2], shift);
  }
  [[nodiscard]] bool operator()(const CellRecord& a, const CellRecord& b) const {
    const std::uint64_t row_a = row(a);
    const std::uint64_t row_b = row(b);
    if (row_a != row_b) return row_a < row_b;
    const std::int32_t slice_a = a.position[0] >> slice_bits_;
    const std::int32_t slice_b = b.position[0] >> slice_bits_;
    return slice_a < slice_b;
  }

 private:
  static constexpr unsigned kFineBits = 2;

  static std::uint64_t rows_across(const Lattice& lattice, std::size_t axis, unsigned row_shift) {
    return ((lattice.cells(axis) - 1) >> row_shift) + 1;
  }
  static unsigned bits_for(std::uint64_t numbers) {
    return static_cast<unsigned>(std::bit_width(numbers - 1));
  }

  unsigned row_bits_;
  unsigned slice_bits_;
  std::uint64_t rows_a_layer_;
  std::uint64_t rows_;
  unsigned x_key_bits_;
  unsigned row_key_bits_;
};

}  // namespace beespace::core
