// Points in a tree of boxes of doubles, for what must not depend on how far apart they are or how
// close together. Nodes of level 0 are the points, in the order of their slots; every other node
// has 16 children, but the last of a level: child c of node i is node 16 i + c of the level below.
// The children of a node lie side by side, axis by axis, so that they are looked at together.
#pragma once

#include "base/bounds.hpp"
#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "tree/point_tree.hpp"

#include <beespace/points_view.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace beespace::core {

struct BoxNode {
  unsigned level;
  std::size_t index;
};

// The box of a single point.
inline Bounds box_around(const Point& point) {
  return {{point.x, point.y, point.z}, {point.x, point.y, point.z}};
}

inline void extend(Bounds& bounds, const Bounds& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bounds.low[axis] = std::min(bounds.low[axis], other.low[axis]);
    bounds.high[axis] = std::max(bounds.high[axis], other.high[axis]);
  }
}

class BoxTree {
 public:
  // Of at least one point, all in the domain. Memory: 34 bytes a point, and 16 more while it
  // builds.
  BoxTree(const PointsView& points, const Resources& with);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] BoxNode root() const { return {top_, 0}; }
  [[nodiscard]] std::size_t nodes(unsigned level) const { return ((size_ - 1) >> (4 * level)) + 1; }
  // Nodes of all levels have numbers of their own, below node_count(): points that of their slot.
  [[nodiscard]] std::size_t number(const BoxNode& node) const {
    return first_of_level_[node.level] + node.index;
  }
  [[nodiscard]] std::size_t node_count() const { return number(root()) + 1; }
  [[nodiscard]] Bounds box(const BoxNode& node) const {
    return node.level == 0 ? box_around(point(node.index)) : boxes_[number(node) - size_];
  }

  [[nodiscard]] std::size_t first_slot(const BoxNode& node) const {
    return node.index << (4 * node.level);
  }
  [[nodiscard]] std::size_t end_slot(const BoxNode& node) const {
    return std::min((node.index + 1) << (4 * node.level), size_);
  }
  // Of a level 1 or higher.
  [[nodiscard]] BoxNode first_child(const BoxNode& node) const {
    return {node.level - 1, node.index * kFanOut};
  }
  template <class Visit>
  void for_each_child(const BoxNode& node, Visit&& visit) const {
    const std::size_t end = std::min((node.index + 1) * kFanOut, nodes(node.level - 1));
    for (std::size_t i = node.index * kFanOut; i < end; ++i) visit(BoxNode{node.level - 1, i});
  }

  // The corners of a node's children, of a level 1 or higher: [axis * kFanOut + child]. Where there
  // is no child, the low one is infinite; of points, both are the same.
  [[nodiscard]] const double* low_corners(const BoxNode& node) const {
    return node.level == 1 ? leaf(node.index) : row(node).low;
  }
  [[nodiscard]] const double* high_corners(const BoxNode& node) const {
    return node.level == 1 ? leaf(node.index) : row(node).high;
  }
  // The points of a node of level 1, likewise.
  [[nodiscard]] const double* leaf(std::size_t index) const { return leaves_[index].at; }
  [[nodiscard]] Point point(std::size_t slot) const {
    const double* const at = leaf(slot / kFanOut) + slot % kFanOut;
    return {at[0], at[kFanOut], at[2 * kFanOut]};
  }

  // The nodes of the highest level that has at least so many; of points, if none has.
  [[nodiscard]] unsigned level_with(std::size_t enough) const {
    unsigned level = top_;
    while (level > 0 && nodes(level) < enough) --level;
    return level;
  }

  // Which of the view's points is in a slot.
  [[nodiscard]] std::uint32_t index(std::size_t slot) const { return order_[slot]; }

 private:
  struct Leaf {
    double at[3 * kFanOut];
  };
  struct Row {
    double low[3 * kFanOut];
    double high[3 * kFanOut];
  };

  [[nodiscard]] const Row& row(const BoxNode& node) const {
    return rows_[number(node) - first_of_level_[2]];
  }
  void fill_leaf(const PointsView& points, std::size_t index);
  void fill_row(const BoxNode& node);

  std::size_t size_;
  unsigned top_ = 0;
  std::size_t first_of_level_[kMostLevels + 2] = {};
  Buffer<Leaf> leaves_;
  Buffer<std::uint32_t> order_;
  Buffer<Bounds> boxes_;  // of the levels above the points
  Buffer<Row> rows_;      // of the levels above the leaves
};

}  // namespace beespace::core
