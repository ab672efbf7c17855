#include "search/shell_walk.hpp"

#include "exact/exact_distance.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace beespace::search {

void ShellWalk::find_nearest(const Point& place, core::NearestList& list) const {
  const Point& centre = tree_.centre();
  const cpu::PlaceAroundCentre around{{place.x - centre.x, place.y - centre.y, place.z - centre.z},
                                      core::squared_distance(place, centre)};
  visit(tree_.top(), 0, place, around, list);
}

// The nearest child first: that shows which of the others need not be looked at.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the tree
void ShellWalk::visit(unsigned level, std::size_t node, const Point& place,
                      const cpu::PlaceAroundCentre& around, core::NearestList& list) const {
  double least[core::kFanOut];
  kernels_.least_squares(around, tree_.row(level, node), least);
  const auto enter = [&](std::size_t lane) {
    const std::size_t child = node * core::kFanOut + lane;
    if (level == 0) {
      offer_leaf(child, place, list);
    } else {
      visit(level - 1, child, place, around, list);
    }
  };
  const auto nearest =
      static_cast<std::size_t>(std::min_element(least, least + core::kFanOut) - least);
  if (least[nearest] > list.largest_squared) return;
  enter(nearest);
  for (std::size_t lane = 0; lane < core::kFanOut; ++lane) {
    if (lane != nearest && least[lane] <= list.largest_squared) enter(lane);
  }
}

void ShellWalk::offer_leaf(std::size_t leaf, const Point& place, core::NearestList& list) const {
  ++list.leaves;
  const double at[3] = {place.x, place.y, place.z};
  const double* const points = tree_.leaf(leaf);
  const cpu::BoxesAround seen =
      kernels_.look(at, at, {points, points}, {0.0, list.largest_squared});
  std::uint32_t within = seen.near | seen.open | seen.unsure;
  for (; within != 0; within &= within - 1) {
    const std::size_t slot =
        leaf * core::kFanOut + static_cast<std::size_t>(std::countr_zero(within));
    if (slot >= tree_.size()) return;
    const Point& point = tree_.point(slot);
    const double squared = core::squared_distance(point, place);
    if (squared <= list.largest_squared) list.offer(point, tree_.id(slot), squared);
  }
}

}  // namespace beespace::search
