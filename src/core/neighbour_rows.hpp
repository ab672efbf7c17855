// All neighbours of some points, on every side: for searches that ask for a few points at a time.
// (near_pairs.hpp is for all points, and looks at each pair once.)
#pragma once

#include "core/near_pairs.hpp"
#include "core/sorted_grid.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace beespace::core {

class NeighbourRows {
 public:
  explicit NeighbourRows(const SortedGrid& grid) : grid_(grid) {}

  // Finds the rows around `row`; rows must come in ascending order.
  void select(std::size_t row) {
    const std::uint64_t number = grid_.row_number[row];
    // Rows y-1, y, y+1 of the layers below, at and above. Layer 0 has none below.
    for (std::uint64_t layer = 0; layer < 3; ++layer) {
      const std::uint64_t middle = number + layer * grid_.rows_a_layer;
      if (middle < grid_.rows_a_layer + 1) {
        around_[layer] = {0, 0};
        continue;
      }
      const std::uint64_t first = middle - grid_.rows_a_layer - 1;
      cursor_[layer] = grid_.skip_to(first, cursor_[layer]);
      around_[layer] = {cursor_[layer], grid_.skip_to(first + 3, cursor_[layer])};
    }
  }

  // Calls visit(j, squared distance in units) for the other points of the cells around sorted
  // point i of the selected row that are at most `farthest` away, until it returns true; returns
  // whether it did.
  template <class Visit>
  bool any_near(std::uint32_t i, float farthest, Visit&& visit) const {
    const std::int32_t cell = grid_.x[i] >> grid_.fraction_bits;
    const std::int32_t first_x = (cell - 1) * (1 << grid_.fraction_bits);
    for (const Rows& rows : around_) {
      for (std::size_t row = rows.begin; row < rows.end; ++row) {
        const std::int32_t* end = grid_.x + grid_.row_begin[row + 1];
        // A row stands in the order of its cells, so this is a valid partition point.
        const std::int32_t* at = std::partition_point(grid_.x + grid_.row_begin[row], end,
                                                      [=](std::int32_t x) { return x < first_x; });
        for (; at != end && *at >> grid_.fraction_bits <= cell + 1; ++at) {
          const auto j = static_cast<std::uint32_t>(at - grid_.x);
          const float squared = squared_units(grid_, i, j);
          if (squared <= farthest && i != j && visit(j, squared)) return true;
        }
      }
    }
    return false;
  }

 private:
  struct Rows {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  const SortedGrid& grid_;
  std::array<Rows, 3> around_{};
  std::array<std::size_t, 3> cursor_{};
};

}  // namespace beespace::core
