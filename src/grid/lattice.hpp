// Cells in space: doubles become fixed-point numbers whose high bits name a cell.
//
//   position = (coordinate - low) * units_per_m      in units, 2^fraction_bits of them a cell
//   cell     = position >> fraction_bits
//
// A lattice is made for a *reach*: cells are at least reach * (1 + margin) wide, so two points
// closer than the reach lie in the same or in adjacent cells, whatever was rounded. The margin is
// max(2^-20, 8 * 2^-53 * extent / reach): a position carries a relative error of 2 * 2^-53, so the
// positions of two points are as far apart as the points, give or take less than
// 4 * 2^-53 * extent / reach cells.
//
// Empty space costs nothing: an axis that would have more than 2^24 cells (the whole earth, of a
// metre each) is folded, which cuts out every gap that no point lies in. There are then at most a
// handful of cells a point, on each axis. More cells have fewer bits for what is within: 5 here,
// with which one pair in eight of those around the reach is too close to it to be decided by
// positions; a lower limit would sort the coordinates of many a swarm that is merely wide.
#pragma once

#include "base/bounds.hpp"
#include "base/resources.hpp"

#include <beespace/points_view.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <span>

namespace beespace::core {

class Lattice {
 public:
  static constexpr std::uint64_t kFoldBeyondCells = std::uint64_t{1} << 24;

  static constexpr std::uint64_t kMostCells = std::uint64_t{1} << 29;  // positions below 2^30

  // For all points of the `sets`, whose bounds are `bounds`. The last two are lowered by tests
  // only. Working memory: 16 bytes for each stretch of a folded axis, and 16 a point while one is
  // folded.
  Lattice(std::span<const PointsView> sets, const Bounds& bounds, double reach, Memory& memory,
          std::uint64_t fold_beyond_cells = kFoldBeyondCells,
          std::uint64_t most_cells = kMostCells);

  // Position of a point's coordinate on `axis`, in units: below cells(axis) << fraction_bits(),
  // itself at most 2^30, monotone in `value`.
  [[nodiscard]] std::int32_t position(std::size_t axis, double value) const {
    const Axis& a = axes_[axis];
    if (a.folded()) [[unlikely]] {
      return folded_position(a, value);
    }
    return static_cast<std::int32_t>((value - a.low) * units_per_m_);
  }
  // The same for `count` coordinates at once.
  void positions(std::size_t axis, const double* values, std::size_t count,
                 std::int32_t* positions) const;

  // The positions of points that are consecutive in memory, of whose three coordinates place[axis]
  // is on `axis`. Not on a folded lattice.
  void positions(const double* xyz, const std::array<std::size_t, 3>& place, std::size_t count,
                 const std::array<std::int32_t*, 3>& positions) const;

  // Whether an axis is folded.
  [[nodiscard]] bool folded() const {
    return axes_[0].folded() || axes_[1].folded() || axes_[2].folded();
  }

  [[nodiscard]] std::uint32_t cell(std::size_t axis, double value) const {
    return static_cast<std::uint32_t>(position(axis, value)) >> fraction_bits_;
  }

  [[nodiscard]] std::uint64_t cells(std::size_t axis) const { return axes_[axis].cells; }
  [[nodiscard]] unsigned fraction_bits() const { return fraction_bits_; }
  [[nodiscard]] double units_per_m() const { return units_per_m_; }
  [[nodiscard]] double cell_m() const { return cell_m_; }

 private:
  // Stretches are runs of coordinates without a wide gap, ascending; a folded axis has some.
  struct Axis {
    explicit Axis(Memory& memory)
        : first(&memory), last(&memory), first_cell(&memory), guide(&memory) {}

    double low = 0.0;
    std::uint64_t cells = 1;
    Vector<double> first;  // the lowest coordinate of each stretch
    Vector<double> last;   // and the highest, until its cells are numbered
    Vector<std::uint32_t> first_cell;
    // By the high bits of a coordinate's key, from that of the lowest on: the last stretch that
    // begins at or below the lowest coordinate with these bits.
    Vector<std::uint32_t> guide;
    std::uint64_t lowest_key = 0;
    unsigned key_shift = 0;

    [[nodiscard]] bool folded() const { return !first.empty(); }
  };

  double fold(std::span<const PointsView> sets, std::size_t axis, double gap, Memory& memory);
  static void join_stretches(Axis& axis, double gap);
  bool count_cells(const Bounds& bounds);
  void number_cells(Axis& axis) const;
  [[nodiscard]] std::uint64_t cells_of(double extent) const;
  static void make_guide(Axis& axis);
  [[nodiscard]] std::int32_t folded_position(const Axis& axis, double value) const;

  std::array<Axis, 3> axes_;
  std::uint64_t most_cells_;
  double cell_m_ = 0.0;
  double units_per_m_ = 0.0;
  unsigned fraction_bits_ = 0;
};

}  // namespace beespace::core
