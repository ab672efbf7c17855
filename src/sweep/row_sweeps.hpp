// The rows that each row is swept against: gives the kernels their work, row by row.
#pragma once

#include "base/stopping.hpp"
#include "exact/exact_distance.hpp"
#include "grid/sorted_grid.hpp"
#include "kernels/sweep.hpp"

#include <beespace/points_view.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace beespace::cpu {

// One side of a sweep: points in order, and where the caller has them.
struct Swarm {
  const core::SortedGrid& grid;
  const PointsView& points;

  [[nodiscard]] Point point(std::uint32_t sorted) const { return points[grid.id[sorted]]; }
};

// The query: which points of `asked` are within the test's threshold of which of `others`. Both
// grids are of one lattice and one row shift. The same swarm twice: which of its points are near
// each other.
struct SweepQuery {
  Swarm asked;
  Swarm others;
  const core::ProximityTest& closer;
  Limits limits;
  const Kernels& kernels;
  bool same_set;  // also when the grids are two, of some points of a set and of others of it
  std::int32_t reach_cells = 1;  // the reach, at most the width of a row

  [[nodiscard]] bool by_itself() const { return &asked.grid == &others.grid; }
  [[nodiscard]] bool decide(std::uint32_t i, std::uint32_t j) const {
    return closer(asked.point(i), others.point(j));
  }
};

// The query decides unsure pairs; it must outlive this object.
inline Unsure decided_by(const SweepQuery& question) {
  // Where a crowd is exactly as far off as the threshold, nothing else is done for seconds.
  const auto decide = [](void* asking, std::uint32_t i, std::uint32_t j) {
    return !core::is_stopping() && static_cast<const SweepQuery*>(asking)->decide(i, j);
  };
  return {decide, const_cast<SweepQuery*>(&question)};
}

class RowSweeps {
 public:
  // The rows that a swarm by itself is swept against: its own and the later ones around it, its own
  // and all around it, or all nine alike, as between two swarms.
  enum class Around { kLaterRows, kAllRows, kOwnRowToo };

  RowSweeps(const SweepQuery& question, const Unsure& unsure, Around around = Around::kLaterRows)
      : asked_(question.asked.grid),
        others_(question.others.grid),
        by_itself_(question.by_itself() && around != Around::kOwnRowToo),
        later_only_(by_itself_ && around == Around::kLaterRows),
        sweep_{positions(asked_),
               positions(others_),
               others_.fraction_bits,
               others_.row_shift,
               others_.slice_bits,
               question.reach_cells,
               question.limits,
               question.same_set,
               {0, 0},
               {0, 0},
               {},
               0,
               unsure} {}

  // Calls visit(sweep) with sweeps that together have the sorted points [begin, end) as queries.
  template <class Visit>
  void for_each(std::uint32_t begin, std::uint32_t end, Visit&& visit) {
    cursors_ = {};
    for (std::size_t row = row_of(asked_, begin); begin < end; ++row) {
      const std::uint32_t row_end = asked_.row_begin[row + 1];
      sweep_.points = {begin, std::min(end, row_end)};
      sweep_.own = by_itself_ ? Range{asked_.row_begin[row], row_end} : Range{0, 0};
      find_targets(asked_.row_number[row]);
      begin = sweep_.points.end;
      if (has_no_candidates()) continue;
      if (!visit_in_parts(visit)) return;
    }
  }

  // Where the others begin and end that the sorted points [begin, end) may look at.
  [[nodiscard]] Range reach(std::uint32_t begin, std::uint32_t end) const {
    if (begin == end) return {0, 0};
    const std::uint64_t step = others_.rows_a_layer + 1;
    const std::uint64_t first = asked_.row_number[row_of(asked_, begin)];
    const std::uint64_t last = asked_.row_number[row_of(asked_, end - 1)];
    const auto& numbers = others_.row_number;
    const auto after = std::upper_bound(numbers.begin(), numbers.end(), last + step);
    const auto from = std::lower_bound(numbers.begin(), after, first < step ? 0 : first - step);
    return {
        later_only_ ? begin : others_.row_begin[static_cast<std::size_t>(from - numbers.begin())],
        others_.row_begin[static_cast<std::size_t>(after - numbers.begin())]};
  }

 private:
  static Positions positions(const core::SortedGrid& grid) {
    return {grid.x, grid.y, grid.z, grid.id};
  }

  static std::size_t row_of(const core::SortedGrid& grid, std::uint32_t point) {
    const auto& begins = grid.row_begin;
    return static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), point) -
                                    begins.begin()) -
           1;
  }

  // A row may hold all points, whose comparisons take minutes: it is swept part by part, and given
  // up between two of them.
  template <class Visit>
  bool visit_in_parts(Visit&& visit) {
    std::uint64_t candidates = sweep_.own.end - sweep_.own.begin;
    for (unsigned k = 0; k < sweep_.target_count; ++k) {
      candidates += sweep_.targets[k].points.end - sweep_.targets[k].points.begin;
    }
    const Range row = sweep_.points;
    const std::uint32_t at_once =
        candidates * (row.end - row.begin) < kManyComparisons ? row.end - row.begin : kPart;
    while (sweep_.points.begin < row.end) {
      sweep_.points.end = sweep_.points.begin + std::min(at_once, row.end - sweep_.points.begin);
      if (core::is_stopping()) return false;
      if (!visit(static_cast<const Sweep&>(sweep_))) return false;
      sweep_.points.begin = sweep_.points.end;
    }
    return true;
  }

  void find_targets(std::uint64_t number) {
    const std::uint64_t layer = others_.rows_a_layer;
    sweep_.target_count = 0;
    if (later_only_) {
      add_targets(number + 1, number + 1, kHighY, 0);
      add_targets(number + layer - 1, number + layer + 1, kHighZ | kLowY, 2);
      return;
    }
    if (number > layer) add_targets(number - layer - 1, number - layer + 1, kLowZ | kLowY, 0);
    if (by_itself_) {
      add_targets(number - 1, number - 1, kLowY, 1);
      add_targets(number + 1, number + 1, kHighY, 3);
    } else {
      add_targets(number - 1, number + 1, kLowY, 1);
    }
    add_targets(number + layer - 1, number + layer + 1, kHighZ | kLowY, 2);
  }

  // The rows of numbers first to last, of which `first` is beyond the sides given, the next one
  // not in y, and the one after that on the other side in y.
  void add_targets(std::uint64_t first, std::uint64_t last, unsigned sides, std::size_t cursor) {
    std::size_t& row = cursors_[cursor];
    row = others_.skip_to(first, row);
    for (std::size_t next = row; next < others_.rows() && others_.row_number[next] <= last;
         ++next) {
      const std::uint64_t steps = others_.row_number[next] - first;
      const unsigned in_z = sides & (kLowZ | kHighZ);
      const unsigned beyond = steps == 0 ? sides : steps == 1 ? in_z : in_z | kHighY;
      sweep_.targets[sweep_.target_count++] = {
          {others_.row_begin[next], others_.row_begin[next + 1]}, beyond};
    }
  }

  [[nodiscard]] bool has_no_candidates() const {
    return sweep_.target_count == 0 && sweep_.own.end - sweep_.own.begin < 2;
  }

  // Some milliseconds; and so many points that what a sweep does first does not count.
  static constexpr std::uint64_t kManyComparisons = std::uint64_t{1} << 21;
  static constexpr std::uint32_t kPart = 512;

  const core::SortedGrid& asked_;
  const core::SortedGrid& others_;
  bool by_itself_;
  bool later_only_;
  Sweep sweep_;
  std::array<std::size_t, 4> cursors_{};
};

}  // namespace beespace::cpu
