#include "cylinders/cylinder_tree.hpp"

#include <algorithm>
#include <limits>

namespace beespace::core {

namespace {

constexpr std::size_t kLanes = UprightLeaf::kLanes;
constexpr double kNowhere = std::numeric_limits<double>::infinity();

std::size_t node_count_of(std::size_t size) {
  std::size_t all = 0;
  std::size_t nodes = size;
  do {
    nodes = (nodes + CylinderTree::kFanOut - 1) / CylinderTree::kFanOut;
    all += nodes;
  } while (nodes > 1);
  return all;
}

}  // namespace

CylinderTree::CylinderTree(const UprightPoints& points, const CylinderSize& size,
                           const Resources& with)
    : size_(points.size()),
      order_(cylinder_order(points, size, kLanes, with)),
      leaves_(with.memory, (points.size() + kLanes - 1) / kLanes),
      boxes_(with.memory, node_count_of(points.size())) {
  with.crew.split(nodes(0), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) fill_leaf(points, leaf);
  });
  while (nodes(top_) > 1) {
    first_of_level_[top_ + 1] = first_of_level_[top_] + nodes(top_);
    ++top_;
    for (std::size_t node = 0; node < nodes(top_); ++node) fill_node(top_, node);
  }
}

void CylinderTree::fill_leaf(const UprightPoints& points, std::size_t leaf) {
  UprightLeaf& to = leaves_[leaf];
  const std::size_t first = first_slot(0, leaf);
  const std::size_t lanes = count(0, leaf);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const Upright place = points[order_[first + lane]];
    for (std::size_t axis = 0; axis < Upright::kAxes; ++axis) to.at[axis][lane] = place.at[axis];
  }
  UprightBox& box = boxes_[leaf];
  for (std::size_t axis = 0; axis < Upright::kAxes; ++axis) {
    const double* const at = to.at[axis];
    box.low[axis] = *std::min_element(at, at + lanes);
    box.high[axis] = *std::max_element(at, at + lanes);
    std::fill(to.at[axis] + lanes, to.at[axis] + kLanes, kNowhere);
  }
}

void CylinderTree::fill_node(unsigned level, std::size_t node) {
  const std::size_t first = first_child(node);
  UprightBox all = box(level - 1, first);
  for (std::size_t child = first + 1; child < end_child(level, node); ++child) {
    const UprightBox& one = box(level - 1, child);
    for (std::size_t axis = 0; axis < Upright::kAxes; ++axis) {
      all.low[axis] = std::min(all.low[axis], one.low[axis]);
      all.high[axis] = std::max(all.high[axis], one.high[axis]);
    }
  }
  boxes_[number(level, node)] = all;
}

}  // namespace beespace::core
