// Points in the order of a tree of boxes, for questions whose answer is often the same for whole
// boxes of them: all within the threshold of all of another box, or none.
//
// Every leaf holds 16 points, every node 16 children, but the last of a level; child c of node i is
// node 16 i + c of the level below, so nothing points to anything. Nodes have boxes of the given
// doubles, by which BoxTest (box_test.hpp) decides for all of their points at once, however crowded
// these are. Leaves and points have lattice positions, which kernels compare many at a time and
// leave open where rounding may have decided.
#pragma once

#include "base/bounds.hpp"
#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "grid/lattice.hpp"
#include "tree/point_tree.hpp"

#include <beespace/points_view.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace beespace::core {

inline constexpr std::size_t kLeafPoints = kFanOut;
inline constexpr std::size_t kNodePoints = kFanOut * kLeafPoints;  // of level 0

// Of the leaves of a node of level 0, in lattice positions: the least and the greatest that occur.
struct alignas(64) LeafBoxes {
  std::int32_t low[3][kFanOut];  // kNowhere where there is no leaf
  std::int32_t high[3][kFanOut];
};

class CrowdTree {
 public:
  // A position that is far from all others: they are in [0, 2^30), and a threshold is at most 2^22.
  // The difference to it fits an int.
  static constexpr std::int32_t kNowhere = -(std::int32_t{1} << 30);

  // Of at least one point, in `bounds`. The view must outlive the tree. Working memory: 44 bytes a
  // point, of which the tree keeps 19.
  CrowdTree(const PointsView& points, const Bounds& bounds, const Lattice& lattice,
            const Resources& with);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] unsigned top() const { return top_; }  // the root is node 0 of this level
  [[nodiscard]] std::size_t nodes(unsigned level) const {
    return ((size() - 1) >> shift(level)) + 1;
  }
  [[nodiscard]] const Bounds& box(unsigned level, std::size_t node) const {
    return boxes_[number(level, node)];
  }
  // Nodes of all levels have numbers of their own, below node_count().
  [[nodiscard]] std::size_t number(unsigned level, std::size_t node) const {
    return first_of_level_[level] + node;
  }
  [[nodiscard]] std::size_t node_count() const { return number(top_, 0) + 1; }
  [[nodiscard]] const LeafBoxes& leaf_boxes(std::size_t node) const { return leaf_boxes_[node]; }

  // The slots of a node are [first_slot, end_slot); those of leaf l of a node of level 0 begin at
  // first_slot + 16 l.
  [[nodiscard]] std::size_t first_slot(unsigned level, std::size_t node) const {
    return node << shift(level);
  }
  [[nodiscard]] std::size_t end_slot(unsigned level, std::size_t node) const {
    return std::min((node + 1) << shift(level), size());
  }
  [[nodiscard]] std::size_t leaves() const { return padded_ / kLeafPoints; }
  [[nodiscard]] std::size_t leaves(std::size_t node) const {
    return (end_slot(0, node) - first_slot(0, node) + kLeafPoints - 1) / kLeafPoints;
  }

  // Of a level 1 or higher.
  [[nodiscard]] std::size_t first_child(std::size_t node) const { return node * kFanOut; }
  [[nodiscard]] std::size_t end_child(unsigned level, std::size_t node) const {
    return std::min((node + 1) * kFanOut, nodes(level - 1));
  }

  // By slot; readable to the end of the last leaf, where there is kNowhere.
  [[nodiscard]] const std::int32_t* positions(std::size_t axis) const {
    return positions_.data() + axis * padded_;
  }
  // Which of the view's points is in a slot.
  [[nodiscard]] std::uint32_t index(std::size_t slot) const { return order_[slot]; }
  [[nodiscard]] Point point(std::size_t slot) const { return points_[order_[slot]]; }

 private:
  static unsigned shift(unsigned level) { return 8 + 4 * level; }

  void prefetch(std::size_t node) const;
  void fill_node(std::size_t node, const Lattice& lattice);

  PointsView points_;
  std::size_t padded_;
  unsigned top_ = 0;
  std::size_t first_of_level_[kMostLevels] = {};
  Buffer<std::uint32_t> order_;
  Buffer<std::int32_t> positions_;
  Buffer<LeafBoxes> leaf_boxes_;
  Buffer<Bounds> boxes_;
};

}  // namespace beespace::core
