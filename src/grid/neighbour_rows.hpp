// All neighbours of some query points, on every side: for searches with few queries at a time. The
// queries and their neighbours may be in two grids of one lattice and row shift. (near_pairs.hpp is
// for all points, and compares each pair once.)
#pragma once

#include "grid/near_pairs.hpp"
#include "grid/sorted_grid.hpp"

#include <array>
#include <cstdint>

namespace beespace::core {

class NeighbourRows {
 public:
  // Those around are at most `reach_cells` away on an axis, itself at most the width of a row.
  NeighbourRows(const SortedGrid& asked, const SortedGrid& others, std::int32_t reach_cells = 1)
      : asked_(asked), grid_(others), reach_cells_(reach_cells) {}

  // Finds the rows around row `row` of the queries; rows must come in ascending order.
  void select(std::size_t row) {
    const std::uint64_t number = asked_.row_number[row];
    count_ = 0;
    // Rows y-1, y, y+1 of the layers below, at and above. Layer 0 has none below.
    for (std::uint64_t layer = 0; layer < 3; ++layer) {
      const std::uint64_t middle = number + layer * grid_.rows_a_layer;
      if (middle < grid_.rows_a_layer + 1) continue;
      const std::uint64_t first = middle - grid_.rows_a_layer - 1;
      cursor_[layer] = grid_.skip_to(first, cursor_[layer]);
      for (std::size_t near = cursor_[layer];
           near < grid_.rows() && grid_.row_number[near] < first + 3; ++near) {
        windows_[count_++] = {grid_.row_begin[near], grid_.row_begin[near + 1]};
      }
    }
  }

  // Calls visit(j, squared distance in units) for the points of the cells around sorted point i of
  // the selected row that are at most `farthest` away (it may be among them itself), until it
  // returns true; returns whether it did. Within a row, points must come in ascending order.
  template <class Visit>
  bool any_near(std::uint32_t i, float farthest, Visit&& visit) {
    const std::int32_t cell = asked_.x[i] >> asked_.fraction_bits;
    for (unsigned k = 0; k < count_; ++k) {
      Window& window = windows_[k];
      const auto cell_of = [this](std::uint32_t j) { return grid_.x[j] >> grid_.fraction_bits; };
      // Rows stand in the order of their cells, so windows only move forward.
      while (window.begin < window.end && cell_of(window.begin) < cell - reach_cells_) {
        ++window.begin;
      }
      for (std::uint32_t j = window.begin; j < window.end && cell_of(j) <= cell + reach_cells_;
           ++j) {
        const float squared = squared_units(asked_, i, grid_, j);
        if (squared <= farthest && visit(j, squared)) return true;
      }
    }
    return false;
  }

 private:
  struct Window {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  const SortedGrid& asked_;
  const SortedGrid& grid_;
  std::int32_t reach_cells_;
  std::array<Window, 9> windows_{};
  unsigned count_ = 0;
  std::array<std::size_t, 3> cursor_{};
};

}  // namespace beespace::core
