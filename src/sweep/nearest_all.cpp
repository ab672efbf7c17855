#include "sweep/nearest_all.hpp"

#include "grid/neighbour_rows.hpp"

#include <beespace/nearest.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace beespace::cpu {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

// Distances in units are wrong by less than 2 (see SquaredLimits): beyond this squared distance
// none can be nearer than a point at `squared`.
float not_surely_farther(float squared) {
  const float units = std::sqrt(squared) + 4.0F;
  return units * units * (1.0F + 0x1p-18F);
}

// Whether a second is farther, as nearly always: without a root, as 8 sqrt(s) <= s / 512 + 8192.
bool is_much_farther(float second, float squared) {
  return second > (squared * (1.0F + 0x1p-9F) + 8256.0F) * (1.0F + 0x1p-17F);
}

// The points of one row that one worker asks for, a few hundred at a time.
struct Batch {
  static constexpr std::uint32_t kMost = 512;

  std::array<float, kMost> best;
  std::array<float, kMost> second;
  std::array<std::uint32_t, kMost> who;
};

class NearestAll {
 public:
  NearestAll(const SweepQuery& question, PointId* nearest)
      : question_(question),
        nearest_(nearest),
        around_(question.asked.grid, question.others.grid, question.reach_cells) {}

  // Asks for the sorted points [begin, end).
  void ask(std::uint32_t begin, std::uint32_t end) {
    // The kernel has no limits: each point that it compares counts, and surely so.
    SweepQuery everything = question_;
    everything.limits = {kFar, kFar};
    const auto clear = [this](Range points) {
      for (std::uint32_t i = points.begin; i < points.end; ++i) result_of(i) = Nearest::kNone;
    };
    std::uint32_t next = begin;
    RowSweeps rows(everything, {nullptr, nullptr}, RowSweeps::Around::kAllRows);
    rows.for_each(begin, end, [&](const Sweep& row) {
      clear({next, row.points.begin});  // of rows without neighbours
      next = row.points.end;
      ask_row(row);
      return true;
    });
    clear({next, end});
  }

 private:
  void ask_row(const Sweep& row) {
    const Kernels& kernels = question_.kernels;
    const auto kernel = question_.by_itself() ? kernels.nearest : kernels.nearest_asked;
    Sweep part = row;
    for (; part.points.begin < row.points.end; part.points.begin = part.points.end) {
      part.points.end = std::min(row.points.end, part.points.begin + Batch::kMost);
      for (std::uint32_t i = part.points.begin; i < part.points.end; ++i) {
        __builtin_prefetch(&result_of(i), 1);
      }
      kernel(part,
             {batch_.best.data(), batch_.second.data(), batch_.who.data(), part.points.begin});
      write(part.points);
    }
  }

  void write(Range points) {
    for (std::uint32_t i = points.begin; i < points.end; ++i) {
      const std::uint32_t place = i - points.begin;
      const float best = batch_.best[place];
      if (best > question_.limits.far) {
        result_of(i) = Nearest::kNone;
      } else if (is_much_farther(batch_.second[place], best) ||
                 batch_.second[place] > not_surely_farther(best)) [[likely]] {
        result_of(i) = question_.others.grid.id[batch_.who[place]];
      } else {
        if (core::is_stopping()) return;  // a crowd at one distance takes long
        result_of(i) = exactly(i, not_surely_farther(best));
      }
    }
  }

  PointId& result_of(std::uint32_t i) { return nearest_[question_.asked.grid.id[i]]; }

  // Among all that may be as near as `farthest`.
  PointId exactly(std::uint32_t i, float farthest) {
    const core::SortedGrid& grid = question_.asked.grid;
    while (row_ == kNoRow || grid.row_begin[row_ + 1] <= i) {
      row_ = row_ == kNoRow ? first_row(grid, i) : row_ + 1;
      if (grid.row_begin[row_ + 1] > i) around_.select(row_);
    }
    const PointId asking = grid.id[i];
    const Point place = question_.asked.point(i);
    PointId best = Nearest::kNone;
    around_.any_near(i, farthest, [&](std::uint32_t j, float) {
      const PointId id = question_.others.grid.id[j];
      if (question_.same_set && id == asking) return false;
      if (best != Nearest::kNone) {
        const Point other = question_.others.points[id];
        const Point nearest = question_.others.points[best];
        const int sign =
            other == nearest ? 0 : core::compare_distances(place, other, place, nearest);
        if (sign > 0 || (sign == 0 && id > best)) return false;
      }
      best = id;
      return false;
    });
    return best;
  }

  static std::size_t first_row(const core::SortedGrid& grid, std::uint32_t i) {
    return static_cast<std::size_t>(
        std::upper_bound(grid.row_begin.begin(), grid.row_begin.end(), i) - grid.row_begin.begin() -
        1);
  }

  static constexpr std::size_t kNoRow = std::numeric_limits<std::size_t>::max();

  const SweepQuery& question_;
  PointId* nearest_;
  core::NeighbourRows around_;  // of row_
  std::size_t row_ = kNoRow;
  Batch batch_;
};

}  // namespace

void nearest_all(const SweepQuery& question, const core::Resources& with, PointId* nearest) {
  with.crew.split(question.asked.grid.size, [&](std::size_t begin, std::size_t end, unsigned) {
    if (begin == end) return;
    NearestAll(question, nearest)
        .ask(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
  });
}

}  // namespace beespace::cpu
