#include "sweep/expected_work.hpp"

#include "base/hash.hpp"
#include "grid/near_pairs.hpp"
#include "grid/sorted_grid.hpp"

#include <algorithm>
#include <cstdint>

namespace beespace::cpu {

namespace {

using core::SortedGrid;

// Where the points of a row are that are in the cells from `first` to `last`.
Range points_between(const SortedGrid& grid, std::size_t row, std::int32_t first,
                     std::int32_t last) {
  const std::int32_t* const begin = grid.x + grid.row_begin[row];
  const std::int32_t* const end = grid.x + grid.row_begin[row + 1];
  const auto below = [&](std::int32_t cell) {
    // Within a slice in any order, but whole cells are in order.
    const std::int32_t* const found = std::partition_point(
        begin, end, [&](std::int32_t x) { return (x >> grid.fraction_bits) < cell; });
    return static_cast<std::uint32_t>(found - grid.x);
  };
  return {below(first), below(last + 1)};
}

// Calls visit(points, share) for what is around a query point in each row: of the points beyond a
// seam, as large a share is compared as lies beside it.
template <class Visit>
void for_each_window(const SweepQuery& question, std::uint32_t asked, Visit&& visit) {
  const SortedGrid& grid = question.asked.grid;
  const SortedGrid& others = question.others.grid;
  const auto begins = grid.row_begin.begin();
  const auto row = std::upper_bound(begins, grid.row_begin.end(), asked) - begins - 1;
  const std::uint64_t number = grid.row_number[static_cast<std::size_t>(row)];
  const std::int32_t cell = grid.x[asked] >> grid.fraction_bits;
  const double beside_seam =
      std::min(1.0, question.reach_cells / static_cast<double>(std::uint32_t{1} << grid.row_shift));
  const auto& numbers = others.row_number;
  for (std::uint64_t layer = 0; layer < 3; ++layer) {
    const std::uint64_t middle = number + layer * others.rows_a_layer;
    if (middle < others.rows_a_layer + 1) continue;
    const std::uint64_t first = middle - others.rows_a_layer - 1;
    auto near = std::lower_bound(numbers.begin(), numbers.end(), first);
    for (; near != numbers.end() && *near < first + 3; ++near) {
      double share = layer == 1 ? 1.0 : beside_seam;
      if (*near != first + 1) share *= beside_seam;
      visit(points_between(others, static_cast<std::size_t>(near - numbers.begin()),
                           cell - question.reach_cells, cell + question.reach_cells),
            share);
    }
  }
}

double comparisons_of(const SweepQuery& question, std::uint32_t asked) {
  double sum = 0.0;
  for_each_window(question, asked,
                  [&](Range points, double share) { sum += share * (points.end - points.begin); });
  return sum;
}

double comparisons_until_near(const SweepQuery& question, std::uint32_t asked) {
  constexpr double kDecision = 64.0;  // in comparisons by floats
  constexpr std::uint32_t kMostLookedAt = 4096;
  double sum = 0.0;
  bool is_near = false;
  for_each_window(question, asked, [&](Range points, double share) {
    const std::uint32_t looked_at = std::min(points.end - points.begin, kMostLookedAt);
    double here = 0.0;
    for (std::uint32_t i = 0; i < looked_at && !is_near; ++i) {
      const float squared =
          core::squared_units(question.asked.grid, asked, question.others.grid, points.begin + i);
      is_near = squared < question.limits.near;
      here += squared >= question.limits.near && squared <= question.limits.far ? kDecision : 1.0;
    }
    // What was not looked at is as what was.
    if (!is_near && looked_at != 0)
      here *= static_cast<double>(points.end - points.begin) / looked_at;
    sum += share * here;
  });
  return sum;
}

template <class Comparisons>
double expected(const SweepQuery& question, const Comparisons& comparisons) {
  constexpr std::size_t kPointsADraw = 2048;
  constexpr std::size_t kFewestDrawn = 16;
  constexpr std::size_t kMostDrawn = 64;
  const std::size_t size = question.asked.grid.size;
  if (size == 0) return 0.0;
  const std::size_t drawn =
      std::min(size, std::clamp(size / kPointsADraw, kFewestDrawn, kMostDrawn));
  double sum = 0.0;
  for (std::size_t i = 0; i < drawn; ++i) {
    const std::size_t begin = size * i / drawn;
    const std::size_t end = size * (i + 1) / drawn;
    const std::size_t asked = begin + core::mix(i + 1) % (end - begin);
    sum += comparisons(question, static_cast<std::uint32_t>(asked));
  }
  return sum / static_cast<double>(drawn) * static_cast<double>(size);
}

}  // namespace

double expected_comparisons(const SweepQuery& question) {
  return expected(question, comparisons_of);
}

double expected_comparisons_until_near(const SweepQuery& question) {
  return expected(question, comparisons_until_near);
}

}  // namespace beespace::cpu
