// The density around a random point. Estimated from a sample, in a fraction of a millisecond, and
// right for clustered points too, where an average over space is meaningless.
#pragma once

#include "base/bounds.hpp"
#include "base/buffer.hpp"
#include "base/resources.hpp"

#include <beespace/points_view.hpp>

#include <cstdint>

namespace beespace::core {

// Deterministic: the same points give the same answers.
class DensitySample {
 public:
  DensitySample(const PointsView& points, Memory& memory);

  // The expected number of other points in a point's own cell, for cubic cells of side `cell_m`:
  // the share of pairs of the sample that share a cell, times the number of points. A tenth of a
  // neighbour among a million points is estimated as zero.
  [[nodiscard]] double expected_neighbors(double cell_m) const;

  // A cell side with about `wanted` expected neighbours, found from the average over the box
  // downward: at most some 200 evaluations, one for an even swarm. Duplicates share cells of any
  // size and do not count.
  [[nodiscard]] double side_for(double wanted, const Bounds& bounds) const;

  // The share of points that are apart: whose cell holds none of the sample, but for the point
  // itself, where those of the sample's own points hold some on average. Of some of `asked`, or of
  // the sample itself where that is null. Cells are at least `least_m` wide, and at most 2
  // `most_m`.
  [[nodiscard]] double share_apart(const PointsView* asked, double least_m, double most_m) const;

 private:
  struct Slot {
    std::uint64_t cell;
    std::uint32_t points;
  };

  double fill_table(double cells_a_m) const;
  [[nodiscard]] std::uint32_t sampled_around(const Point& point, double cells_a_m) const;
  [[nodiscard]] std::size_t slot_of(std::uint64_t cell) const;

  std::size_t population_;
  std::size_t size_;
  std::size_t slots_;
  Buffer<Point> points_;
  mutable Buffer<Slot> table_;
};

}  // namespace beespace::core
