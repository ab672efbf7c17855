#include "tree/crowd_tree.hpp"

#include "tree/point_tree_order.hpp"

namespace beespace::core {

namespace {

std::size_t leaves_of(std::size_t points) {
  return (points + kLeafPoints - 1) / kLeafPoints;
}

// Also marks the places of the last leaf at which there is no point.
void fill_leaf_boxes(std::int32_t* positions, std::size_t size, std::int32_t* low,
                     std::int32_t* high) {
  for (std::size_t leaf = 0; leaf < kFanOut; ++leaf) {
    const std::size_t begin = leaf * kLeafPoints;
    const std::size_t end = std::min(begin + kLeafPoints, size);
    if (begin >= size) {
      low[leaf] = high[leaf] = CrowdTree::kNowhere;
      continue;
    }
    low[leaf] = high[leaf] = positions[begin];
    for (std::size_t i = begin + 1; i < end; ++i) {
      low[leaf] = std::min(low[leaf], positions[i]);
      high[leaf] = std::max(high[leaf], positions[i]);
    }
    std::fill(positions + end, positions + begin + kLeafPoints, CrowdTree::kNowhere);
  }
}

Buffer<std::uint32_t> order_of(const PointsView& points, const Bounds& bounds,
                               const Resources& with) {
  Buffer<TreeLeaf> leaves(with.memory, leaves_of(points.size()));
  Buffer<Point> slots(with.memory, points.size());
  return point_tree_order(points, bounds, with, leaves, slots);
}

}  // namespace

CrowdTree::CrowdTree(const PointsView& points, const Bounds& bounds, const Lattice& lattice,
                     const Resources& with)
    : points_(points),
      padded_(leaves_of(points.size()) * kLeafPoints),
      order_(order_of(points, bounds, with)),
      positions_(with.memory, 3 * padded_),
      leaf_boxes_(with.memory, nodes(0)) {
  std::size_t boxes = nodes(0);
  while (nodes(top_) > 1) {
    first_of_level_[++top_] = boxes;
    boxes += nodes(top_);
  }
  boxes_ = Buffer<Bounds>(with.memory, boxes);
  with.crew.split(nodes(0), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t node = begin; node < end; ++node) fill_node(node, lattice);
  });
  for (unsigned level = 1; level <= top_; ++level) {
    for (std::size_t node = 0; node < nodes(level); ++node) {
      Bounds around = kNoBox;
      for (std::size_t child = first_child(node); child < end_child(level, node); ++child) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Bounds& part = box(level - 1, child);
          around.low[axis] = std::min(around.low[axis], part.low[axis]);
          around.high[axis] = std::max(around.high[axis], part.high[axis]);
        }
      }
      boxes_[number(level, node)] = around;
    }
  }
}

// Points lie anywhere in memory: those of the next node are asked for while this one is worked on.
void CrowdTree::prefetch(std::size_t node) const {
  if (node >= nodes(0)) return;
  const auto* const first = static_cast<const std::byte*>(points_.axes()[0]);
  const std::ptrdiff_t stride = points_.stride_bytes()[0];
  for (std::size_t slot = first_slot(0, node); slot < end_slot(0, node); ++slot) {
    __builtin_prefetch(first + static_cast<std::ptrdiff_t>(order_[slot]) * stride);
  }
}

void CrowdTree::fill_node(std::size_t node, const Lattice& lattice) {
  prefetch(node + 1);
  const std::size_t begin = first_slot(0, node);
  const std::size_t size = end_slot(0, node) - begin;
  double values[3][kNodePoints];
  for (std::size_t i = 0; i < size; ++i) {
    const Point p = point(begin + i);
    values[0][i] = p.x;
    values[1][i] = p.y;
    values[2][i] = p.z;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(values[axis], values[axis] + size);
    boxes_[node].low[axis] = *low;
    boxes_[node].high[axis] = *high;
    std::int32_t* const at = positions_.data() + axis * padded_ + begin;
    lattice.positions(axis, values[axis], size, at);
    fill_leaf_boxes(at, size, leaf_boxes_[node].low[axis], leaf_boxes_[node].high[axis]);
  }
}

}  // namespace beespace::core
