// The search in its simplest form: every pair of points that may be within the reach, once.
//
// The fast kernels of src/kernels do the same with many pairs an instruction; this is the version
// to read, and the one for searches that need each pair.
#pragma once

#include "grid/sorted_grid.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace beespace::core {

// Squared distances in units of a grid, between which rounding may matter.
//
// Positions are cut to whole units, so the difference of two is wrong by less than 1 unit on an
// axis and a distance by less than 1.75; 2 units leave room for the relative errors, at most 2^-21
// in all, of positions and of float arithmetic. Limits are widened by 2^-18 to cover those.
struct SquaredLimits {
  float surely_near = -1.0F;  // below: within the distance
  float surely_far = 0.0F;    // above: not within the distance

  SquaredLimits(double distance_m, double units_per_m) {
    const double units = distance_m * units_per_m;
    if (units > 2.0) {
      surely_near = static_cast<float>((units - 2.0) * (units - 2.0) * (1.0 - 0x1p-18));
    }
    surely_far = static_cast<float>((units + 2.0) * (units + 2.0) * (1.0 + 0x1p-18));
  }
};

// Between point i of one grid and point j of another of the same lattice.
inline float squared_units(const SortedGrid& grid, std::size_t i, const SortedGrid& other,
                           std::size_t j) {
  const auto dx = static_cast<float>(grid.x[i] - other.x[j]);
  const auto dy = static_cast<float>(grid.y[i] - other.y[j]);
  const auto dz = static_cast<float>(grid.z[i] - other.z[j]);
  return dx * dx + dy * dy + dz * dz;
}

// The rows after `row` that hold neighbours of its points: (y+1) and, a layer up, (y-1, y, y+1).
// `layer_up` is a cursor that only moves forward as `row` does; start it at 0.
inline std::pair<std::array<std::size_t, 4>, unsigned> later_rows(const SortedGrid& grid,
                                                                  std::size_t row,
                                                                  std::size_t& layer_up) {
  std::array<std::size_t, 4> found{};
  unsigned count = 0;
  const std::uint64_t number = grid.row_number[row];
  if (row + 1 < grid.rows() && grid.row_number[row + 1] == number + 1) found[count++] = row + 1;
  layer_up = grid.skip_to(number + grid.rows_a_layer - 1, std::max(layer_up, row + 1));
  for (std::size_t next = layer_up;
       next < grid.rows() && grid.row_number[next] <= number + grid.rows_a_layer + 1; ++next) {
    found[count++] = next;
  }
  return {found, count};
}

// Calls visit(i, j, squared distance in units) for every pair of sorted points in adjacent cells
// whose squared distance in units is at most `farthest`. Each pair once, in no useful order.
// Only those whose first point lies in the rows [first_row, end_row).
template <class Visit>
void for_each_near_pair(const SortedGrid& grid, std::size_t first_row, std::size_t end_row,
                        float farthest, Visit&& visit) {
  std::size_t layer_up = first_row;
  for (std::size_t row = first_row; row < end_row; ++row) {
    const auto [later, later_count] = later_rows(grid, row, layer_up);
    std::array<std::uint32_t, 4> window{};
    for (unsigned k = 0; k < later_count; ++k) window[k] = grid.row_begin[later[k]];

    for (std::uint32_t i = grid.row_begin[row]; i < grid.row_begin[row + 1]; ++i) {
      const std::int32_t cell = grid.x[i] >> grid.fraction_bits;
      const auto scan = [&](std::uint32_t from, std::uint32_t end) {
        for (; from < end && grid.x[from] >> grid.fraction_bits <= cell + 1; ++from) {
          const float squared = squared_units(grid, i, grid, from);
          if (squared <= farthest) visit(i, from, squared);
        }
      };
      scan(i + 1, grid.row_begin[row + 1]);
      for (unsigned k = 0; k < later_count; ++k) {
        const std::uint32_t end = grid.row_begin[later[k] + 1];
        while (window[k] < end && grid.x[window[k]] >> grid.fraction_bits < cell - 1) ++window[k];
        scan(window[k], end);
      }
    }
  }
}

// For all rows.
template <class Visit>
void for_each_near_pair(const SortedGrid& grid, float farthest, Visit&& visit) {
  for_each_near_pair(grid, 0, grid.rows(), farthest, visit);
}

}  // namespace beespace::core
