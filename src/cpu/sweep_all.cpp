#include "cpu/sweep_all.hpp"

#include "core/near_pairs.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace beespace::cpu {

namespace {

// The rows of one worker, and its marks: for its own points and those of the later rows that they
// reach, which another worker may be marking at the same time.
struct Part {
  std::size_t first_row = 0;
  std::size_t end_row = 0;
  std::uint32_t first_mark = 0;
  std::vector<std::uint8_t> marks = {};
};

struct Decision {
  const core::SortedGrid& grid;
  const PointsView& points;
  const core::ProximityTest& closer;
  Part& part;

  static void decide(void* context, std::uint32_t i, std::uint32_t j) {
    const auto& self = *static_cast<const Decision*>(context);
    std::uint8_t& first = self.part.marks[i - self.part.first_mark];
    std::uint8_t& second = self.part.marks[j - self.part.first_mark];
    if (first != 0 && second != 0) return;
    if (!self.closer(self.points[self.grid.id[i]], self.points[self.grid.id[j]])) return;
    first = second = 1;
  }
};

// Rows are dealt out so that every worker has about as many points.
std::size_t first_row_of(const core::SortedGrid& grid, std::size_t point) {
  const auto begins = grid.row_begin.begin();
  return static_cast<std::size_t>(
      std::lower_bound(begins, grid.row_begin.end() - 1, static_cast<std::uint32_t>(point)) -
      begins);
}

// Rows of the grid stand together in memory, so short neighbours make one short run.
Neighbourhood neighbourhood_of(const core::SortedGrid& grid, std::size_t row, const Range& own,
                               const std::array<std::size_t, 4>& later, unsigned later_count) {
  constexpr std::uint32_t kShort = 16;  // the lanes of the widest kernel
  const auto range = [&](std::size_t first, std::size_t last) {
    return Range{grid.row_begin[first], grid.row_begin[last + 1]};
  };
  Neighbourhood hood{own, own.end, {0, 0}, {}, 0};
  unsigned next = 0;
  if (later_count > 0 && later[0] == row + 1 &&
      grid.row_number[row + 1] == grid.row_number[row] + 1) {
    const Range behind = range(row + 1, row + 1);
    if (behind.end - own.begin <= kShort) {
      hood.own_end = behind.end;
    } else {
      hood.later[hood.later_count++] = behind;
    }
    next = 1;
  }
  if (next == later_count) return hood;
  const Range layer_up = range(later[next], later[later_count - 1]);
  if (layer_up.end - layer_up.begin <= kShort) {
    hood.together = layer_up;
  } else {
    for (; next < later_count; ++next) {
      hood.later[hood.later_count++] = range(later[next], later[next]);
    }
  }
  return hood;
}

void sweep_part(const core::SortedGrid& grid, const Limits& limits, SweepKernel kernel, Part& part,
                Decision& decision) {
  if (part.first_row == part.end_row) return;
  const std::uint64_t last_reached = grid.row_number[part.end_row - 1] + grid.rows_a_layer + 1;
  const auto reach_end =
      std::upper_bound(grid.row_number.begin(), grid.row_number.end(), last_reached);
  part.first_mark = grid.row_begin[part.first_row];
  const std::uint32_t end_mark =
      grid.row_begin[static_cast<std::size_t>(reach_end - grid.row_number.begin())];
  part.marks.assign(end_mark - part.first_mark + core::kPadding, 0);

  const Positions positions{grid.x, grid.y, grid.z, grid.fraction_bits};
  const Unsure unsure{&Decision::decide, &decision};
  std::size_t layer_up = part.first_row;
  for (std::size_t row = part.first_row; row < part.end_row; ++row) {
    const auto [later, later_count] = core::later_rows(grid, row, layer_up);
    const Range own{grid.row_begin[row], grid.row_begin[row + 1]};
    if (later_count == 0 && own.end - own.begin == 1) continue;
    const Neighbourhood hood = neighbourhood_of(grid, row, own, later, later_count);
    kernel(positions, hood, limits, part.marks.data(), part.first_mark, unsure);
  }
}

}  // namespace

void sweep_all(const core::SortedGrid& grid, const PointsView& points,
               const core::ProximityTest& closer, double threshold, SweepKernel kernel,
               Crew& crew, std::uint8_t* at_risk) {
  const core::SquaredLimits squared(threshold, grid.units_per_m);
  const Limits limits{squared.surely_near, squared.surely_far};
  std::vector<Part> parts(crew.size());
  crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    Part& part = parts[worker];
    part.first_row = first_row_of(grid, begin);
    part.end_row = first_row_of(grid, end);
    Decision decision{grid, points, closer, part};
    sweep_part(grid, limits, kernel, part, decision);
  });
  // Parts overlap by what they reach of each other, so their marks are merged one after another.
  for (const Part& part : parts) {
    if (part.first_row == part.end_row) continue;
    crew.split(part.marks.size() - core::kPadding,
               [&](std::size_t begin, std::size_t end, unsigned) {
                 for (std::size_t i = begin; i < end; ++i) {
                   std::uint8_t& known = at_risk[grid.id[part.first_mark + i]];
                   known = part.marks[i] != 0 ? 1 : known;
                 }
               });
  }
}

}  // namespace beespace::cpu
