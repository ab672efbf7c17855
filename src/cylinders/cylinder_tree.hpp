// Places in a tree of boxes of (height, x, y, and z where heights are apart), for searches with a
// vertical threshold.
//
// Every leaf holds 8 places and every node 8 children, but the last of a level; child c of node i
// is node 8 i + c of the level below, so nothing points to anything. Leaves are the nodes of level
// 0.
//
// Boxes and places are the given doubles: nothing is stretched, turned or rounded, so nothing can
// be lost but in the comparisons. Those of heights and of horizontal distances are apart:
//
//   heights: a rounded difference d is monotone in the difference, and V is a double; so d < V says
//     that the heights are closer than V, d > V that they are not, and only d = V leaves it open.
//   horizontally: the sum s of the squares of rounded differences has a relative error of at most
//     5 u, u = 2^-53 (exact/exact_distance), X * X one of u, and so has the product with the
//     margin: s < X X (1 - 2^-50) says closer than X, s > X X (1 + 2^-50) not closer. 5 u + u + u <
//     8 u.
//
// The same holds of boxes: the nearest and farthest corners of two boxes are rounded differences of
// given doubles too, and monotone in the places between them. Nothing under- or overflows: in the
// coordinate domain differences are 0 or in [2^-452, 2^401].
#pragma once

#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "cylinders/cylinder_order.hpp"
#include "exact/cylinder.hpp"
#include "tree/box_test.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace beespace::core {

struct UprightBox {
  std::array<double, Upright::kAxes> low;
  std::array<double, Upright::kAxes> high;
};

// Places in lanes, to be compared at once; infinity where there is none.
struct alignas(64) UprightLeaf {
  static constexpr std::size_t kLanes = 8;
  double at[Upright::kAxes][kLanes];
};

class CylinderTree {
 public:
  static constexpr std::size_t kFanOut = UprightLeaf::kLanes;

  // Of at least one place. Working memory: 48 bytes a place, and 8 more while it is built.
  CylinderTree(const UprightPoints& points, const CylinderSize& size, const Resources& with);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] unsigned top() const { return top_; }  // the root is node 0 of this level
  [[nodiscard]] std::size_t nodes(unsigned level) const {
    return ((size_ - 1) >> shift(level)) + 1;
  }
  // Nodes of all levels have numbers of their own, below node_count().
  [[nodiscard]] std::size_t number(unsigned level, std::size_t node) const {
    return first_of_level_[level] + node;
  }
  [[nodiscard]] std::size_t node_count() const { return number(top_, 0) + 1; }
  [[nodiscard]] const UprightBox& box(unsigned level, std::size_t node) const {
    return boxes_[number(level, node)];
  }
  [[nodiscard]] const UprightLeaf& leaf(std::size_t node) const { return leaves_[node]; }

  // The slots of a node; those of a leaf are its lanes.
  [[nodiscard]] std::size_t first_slot(unsigned level, std::size_t node) const {
    return node << shift(level);
  }
  [[nodiscard]] std::size_t end_slot(unsigned level, std::size_t node) const {
    const std::size_t end = (node + 1) << shift(level);
    return end < size_ ? end : size_;
  }
  [[nodiscard]] std::size_t count(unsigned level, std::size_t node) const {
    return end_slot(level, node) - first_slot(level, node);
  }
  // Of a level 1 or higher.
  [[nodiscard]] std::size_t first_child(std::size_t node) const { return node * kFanOut; }
  [[nodiscard]] std::size_t end_child(unsigned level, std::size_t node) const {
    const std::size_t end = (node + 1) * kFanOut;
    return end < nodes(level - 1) ? end : nodes(level - 1);
  }

  // The index of the point in a slot, and its place.
  [[nodiscard]] std::uint32_t index(std::size_t slot) const { return order_[slot]; }
  [[nodiscard]] Upright place(std::size_t slot) const {
    const UprightLeaf& of = leaves_[slot / kFanOut];
    const std::size_t lane = slot % kFanOut;
    return {{of.at[0][lane], of.at[1][lane], of.at[2][lane], of.at[3][lane]}};
  }

 private:
  static constexpr unsigned kMostLevels = 11;  // 8^11 places
  static unsigned shift(unsigned level) { return 3 + 3 * level; }

  void fill_leaf(const UprightPoints& points, std::size_t leaf);
  void fill_node(unsigned level, std::size_t node);

  std::size_t size_;
  unsigned top_ = 0;
  std::array<std::size_t, kMostLevels> first_of_level_{};
  Buffer<std::uint32_t> order_;
  Buffer<UprightLeaf> leaves_;
  Buffer<UprightBox> boxes_;
};

// The verdicts on boxes and places: surely in the cylinder, surely not, or to be decided exactly.
class CylinderBoxTest {
 public:
  explicit CylinderBoxTest(const CylinderSize& size)
      : upright_(size.upright),
        surely_near_(size.level * size.level * (1.0 - 0x1p-50)),
        surely_far_(size.level * size.level * (1.0 + 0x1p-50)) {}

  [[nodiscard]] Reach operator()(const UprightBox& a, const UprightBox& b) const {
    const double up = b.high[0] - a.low[0];
    const double down = a.high[0] - b.low[0];
    if (-up > upright_ || -down > upright_) return Reach::kFar;
    double nearest = 0.0;
    double farthest = 0.0;
    for (std::size_t axis = 1; axis < Upright::kAxes; ++axis) {
      const double ahead = b.high[axis] - a.low[axis];
      const double behind = a.high[axis] - b.low[axis];
      const double most = ahead > behind ? ahead : behind;
      const double gap = ahead < behind ? -ahead : -behind;
      const double least = gap > 0.0 ? gap : 0.0;
      farthest += most * most;
      nearest += least * least;
    }
    if (nearest > surely_far_) return Reach::kFar;
    const bool near = farthest < surely_near_ && up < upright_ && down < upright_;
    return near ? Reach::kNear : Reach::kOpen;
  }

  [[nodiscard]] double upright() const { return upright_; }
  [[nodiscard]] double surely_near() const { return surely_near_; }
  [[nodiscard]] double surely_far() const { return surely_far_; }

 private:
  double upright_;
  double surely_near_;
  double surely_far_;
};

// The tests of a search.
struct CylinderTests {
  CylinderBoxTest boxes;
  CylinderTest places;
};

}  // namespace beespace::core
