// Balls that reach much farther than nearly all others: they are left out of the grid, and compared
// with all others one by one, where that costs less than a grid that suits them.
#pragma once

#include "base/bounds.hpp"
#include "base/resources.hpp"
#include "motion/passing/passing_search.hpp"

#include <beespace/point.hpp>

#include <atomic>
#include <cstdint>
#include <span>

namespace beespace::motion {

// How many all workers have found.
class Total {
 public:
  explicit Total(std::uint64_t most) : most_(most) {}
  // Whether to go on.
  bool add(std::uint64_t found) {
    return found_.fetch_add(found, std::memory_order_relaxed) + found <= most_;
  }

 private:
  std::uint64_t most_;
  std::atomic<std::uint64_t> found_ = 0;
};

// The reach up to which balls come into the grid: all, unless that costs more than to compare a few
// with all others.
double reach_in_grid(const MovingBalls& balls, const Step& step, const core::Resources& with);

// The balls that reach beyond the grid, and those in it, separately.
class Partition {
 public:
  Partition(const MovingBalls& balls, const Step& step, double reach_m,
            const core::Resources& with);

  [[nodiscard]] const MovingBalls& grid() const { return grid_; }
  // Their ids.
  [[nodiscard]] const PointId* in_grid() const { return in_grid_.data(); }
  [[nodiscard]] std::span<const PointId> beyond() const { return beyond_; }

 private:
  core::Vector<PointId> in_grid_;
  core::Vector<PointId> beyond_;
  core::Vector<Point> middles_;
  core::Vector<Move> moves_;
  MovingBalls grid_{};
};

// Adds the pairs of which one is beyond the grid. `beyond` is ascending.
void search_beyond(const MovingBalls& balls, const Step& step, std::span<const PointId> beyond,
                   const core::Resources& with, const DecidePass& decide, Total& total,
                   core::Vector<core::FoundPairs>& found);

}  // namespace beespace::motion
