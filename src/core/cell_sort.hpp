// Brings points into the order of their cells, in two steps that suit the caches: one scatter of
// everything into at most 2048 buckets, then each bucket on its own, in the nearest cache.
#pragma once

#include <beespace/crew.hpp>
#include "core/buffer.hpp"
#include "core/lattice.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace beespace::core {

// A point on its way into the grid. Its lattice positions tell its cell, so no key is carried.
struct CellRecord {
  std::array<std::int32_t, 3> position;
  PointId id;
};

// The order of the grid: rows by (z, y), cells along x within a row. As a number: the cell along x
// in the low bits, the row number above.
class CellOrder {
 public:
  explicit CellOrder(const Lattice& lattice)
      : fraction_bits_(lattice.fraction_bits()),
        rows_a_layer_(lattice.cells(1) + 2),
        x_bits_(static_cast<unsigned>(std::bit_width(lattice.cells(0) - 1))),
        rows_(rows_a_layer_ * lattice.cells(2)),
        row_bits_(static_cast<unsigned>(std::bit_width(rows_ - 1))) {}

  // Row numbers leave a row empty before and behind those of a layer, so that one less and one
  // more never name a row of another layer. Below 2^29 * (2^29 + 2).
  [[nodiscard]] std::uint64_t row(const CellRecord& record) const {
    return cell(record, 2) * rows_a_layer_ + cell(record, 1) + 1;
  }
  [[nodiscard]] std::uint64_t rows_a_layer() const { return rows_a_layer_; }
  [[nodiscard]] std::uint64_t rows() const { return rows_; }

  [[nodiscard]] unsigned key_bits() const { return x_bits_ + row_bits_; }
  // The key from bit `shift` upward. Keys may have more than 64 bits; those beyond are cut off.
  [[nodiscard]] std::uint64_t key(const CellRecord& record, unsigned shift) const {
    if (shift >= x_bits_) return row(record) >> (shift - x_bits_);
    return cell(record, 0) >> shift | row(record) << (x_bits_ - shift);
  }
  [[nodiscard]] bool operator()(const CellRecord& a, const CellRecord& b) const {
    const std::uint64_t row_a = row(a);
    const std::uint64_t row_b = row(b);
    return row_a != row_b ? row_a < row_b : cell(a, 0) < cell(b, 0);
  }

 private:
  [[nodiscard]] std::uint64_t cell(const CellRecord& record, std::size_t axis) const {
    return static_cast<std::uint32_t>(record.position[axis]) >> fraction_bits_;
  }

  unsigned fraction_bits_;
  std::uint64_t rows_a_layer_;
  unsigned x_bits_;
  std::uint64_t rows_;
  unsigned row_bits_;
};

struct SortedCells {
  Buffer<CellRecord> records;
  Buffer<CellRecord> spare;  // as large; the sort is done with it
};

// The records of all points, or of those of `subset` if it is not empty, in the order of their
// cells; points of one cell stand in the order of their ids. Both buffers have room for `room`
// more records. Cost: one look at every point, and two moves of 16 bytes or a few more. Working
// memory: the two buffers, 32 bytes a point.
SortedCells sort_by_cell(const PointsView& points, std::span<const PointId> subset,
                         const Lattice& lattice, const CellOrder& order, std::size_t room,
                         Crew& crew);

}  // namespace beespace::core
