// Places in rows of cells, for searches with a vertical threshold in swarms that are not crowded: a
// row is as high and as wide as the thresholds, and sorted along the third axis, so that each place
// is compared with those in its window of its own row and of the four rows behind it.
//
// No pair is lost: a cell's number is the floor of q = (c - low) / w, each operation rounded, which
// is monotone in the coordinate c. There are at most 2^20 cells along an axis, so q is at most 2^20
// and off by less than 2^20 * 2.01 u < 2^-31, u = 2^-53 (a rounded difference has a relative error,
// whatever the magnitude of c). Cells are w >= X (1 + 2^-20) wide, rounded by no more than 2^-52:
// so two places whose coordinates are at most X apart have q at most 1 - 2^-21 + 2 * 2^-31 < 1
// apart, and are in the same cell or in one beside it. The window ends where a rounded difference
// is above X, which it is of real differences above X only. Pairs are decided as in
// cylinders/cylinder_tree.hpp.
#pragma once

#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "base/stopping.hpp"
#include "cylinders/cylinder_order.hpp"
#include "cylinders/cylinder_tree.hpp"
#include "exact/cylinder.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace beespace::core {

class CylinderRows {
 public:
  // For at least one place. Where so many places share cells that a tree is faster, the rows are
  // left unfinished unless they are `wanted`. Working memory: 60 bytes a place.
  CylinderRows(const UprightPoints& points, const CylinderSize& size, bool wanted,
               const Resources& with);

  // If false, no other member may be called.
  [[nodiscard]] bool finished() const { return finished_; }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint32_t index(std::size_t slot) const { return order_[slot]; }

  // Calls near(i, j) for all pairs of slots that are near each other, on all workers, each with a
  // task of task_of(worker), until its enough().
  template <class TaskOf>
  void for_each_near(const CylinderTests& tests, Crew& crew, const TaskOf& task_of) const;

 private:
  // In the order of the cells: along the row, across it, the remaining axis, and the height.
  struct Place {
    double along;
    double across;
    double rest;
    double height;
  };

  template <class Task>
  void look_at_row(std::size_t row, const CylinderTests& tests, Task& task) const;
  template <class Task>
  void look(std::size_t i, std::size_t begin, std::size_t end, const CylinderTests& tests,
            Task& task) const;

  class Builder;

  std::size_t size_;
  bool finished_ = false;
  double reach_;            // along a row: the threshold
  std::size_t across_ = 1;  // rows beside each other; layers of these lie on each other
  std::size_t rows_ = 1;
  Buffer<std::uint32_t> order_;
  Buffer<Place> places_;
  Buffer<std::uint32_t> begins_;  // of rows, and the end
};

template <class TaskOf>
void CylinderRows::for_each_near(const CylinderTests& tests, Crew& crew,
                                 const TaskOf& task_of) const {
  constexpr std::size_t kAtOnce = 16;
  std::atomic<std::size_t> next{0};
  crew.run([&](unsigned worker) {
    auto task = task_of(worker);
    for (std::size_t first = next.fetch_add(kAtOnce);
         first < rows_ && !task.enough() && !is_stopping(); first = next.fetch_add(kAtOnce)) {
      const std::size_t end = first + kAtOnce < rows_ ? first + kAtOnce : rows_;
      for (std::size_t row = first; row < end; ++row) look_at_row(row, tests, task);
    }
  });
}

template <class Task>
void CylinderRows::look_at_row(std::size_t row, const CylinderTests& tests, Task& task) const {
  const std::size_t begin = begins_[row];
  const std::size_t end = begins_[row + 1];
  if (begin == end) return;
  for (std::size_t i = begin; i < end && !is_stopping(); ++i) look(i, i + 1, end, tests, task);
  const std::size_t at = row % across_;
  std::size_t behind[4];
  std::size_t count = 0;
  if (at + 1 < across_) behind[count++] = row + 1;
  if (row + across_ < rows_) {
    if (at > 0) behind[count++] = row + across_ - 1;
    behind[count++] = row + across_;
    if (at + 1 < across_) behind[count++] = row + across_ + 1;
  }
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t first = begins_[behind[k]];
    const std::size_t last = begins_[behind[k] + 1];
    for (std::size_t i = begin; i < end && first < last && !is_stopping(); ++i) {
      const double along = places_[i].along;
      while (first < last && along - places_[first].along > reach_) ++first;
      look(i, first, last, tests, task);
    }
  }
}

// Place i and the places from `begin` on within its window.
template <class Task>
void CylinderRows::look(std::size_t i, std::size_t begin, std::size_t end,
                        const CylinderTests& tests, Task& task) const {
  const Place here = places_[i];
  for (std::size_t j = begin; j < end; ++j) {
    const Place& there = places_[j];
    const double along = there.along - here.along;
    if (along > reach_) return;
    const double up = std::abs(there.height - here.height);
    const double across = there.across - here.across;
    const double rest = there.rest - here.rest;
    const double squared = along * along + across * across + rest * rest;
    // One branch: which of the two it is cannot be predicted.
    const int may_be_near =
        int{up <= tests.boxes.upright()} & int{squared <= tests.boxes.surely_far()};
    if (may_be_near == 0) continue;
    if (up < tests.boxes.upright() && squared < tests.boxes.surely_near()) {
      task.near(i, j);
    } else if (tests.places({{here.height, here.along, here.across, here.rest}},
                            {{there.height, there.along, there.across, there.rest}})) {
      task.near(i, j);
    }
  }
}

}  // namespace beespace::core
