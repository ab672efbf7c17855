// How many are where: counts in square cells, for swarms whose single marks would hide each
// other.
#pragma once

#include "report/drawing/drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::report {

class Density {
 public:
  // Cells of `side` that cover a rectangle of the drawing.
  Density(Spot corner, double width, double height, double side);

  // One more in the cell of the spot; spots beyond the rectangle count in the cell nearest to them.
  void add(Spot spot);
  // One more in each cell along the way; in each cell once, also if the way comes back to the one
  // that it has just left.
  void add_way(Spot from, Spot to);

  [[nodiscard]] std::uint32_t most() const;
  [[nodiscard]] const std::vector<std::uint32_t>& counts() const { return counts_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }

  // Shades by the logarithm of the count, from the first ink for one to the last one for most().
  [[nodiscard]] Cells cells(std::vector<Ink> inks) const;
  // In each cell that is not empty a mark with an area in proportion to its count; that of most()
  // is most of the cell wide.
  [[nodiscard]] Diamonds diamonds(Ink ink) const;

 private:
  [[nodiscard]] std::size_t cell_of(Spot spot) const;

  Spot corner_;
  double side_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<std::uint32_t> counts_;
};

}  // namespace beespace::report
