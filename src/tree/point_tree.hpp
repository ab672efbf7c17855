// Points in a tree of boxes: what finds those around any place.
//
// Every node has up to 16 children, every leaf up to 16 points, so that vectors of any width look
// at all of them together. All nodes but the last of a level are full; therefore nothing points
// to anything: child c of node i is node 16 i + c of the level below.
//
//   level 1                 [ 16 boxes ]                 nodes, the root on top
//   level 0      [ 16 boxes ][ 16 boxes ] ... [ 3 boxes ]
//   leaves       [16][16][16][16] ...           [16][16][7]
//
// Boxes and points are floats in the frame of their node: scale * (position - origin), where scale
// is a power of two. All points of a node of level 0 lie in [-1, 1]; above, most of the boxes lie
// in a wider frame. So the floats resolve a crowd as well as a continent, wherever it lies and
// whatever lies around it. What they promise is derived in kernels/frame_place_kernel.hpp; what
// they leave open, the doubles decide.
#pragma once

#include "base/bounds.hpp"
#include "base/buffer.hpp"
#include "base/resources.hpp"

#include <beespace/crew.hpp>
#include <beespace/points_view.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace beespace::core {

inline constexpr std::size_t kFanOut = 16;
inline constexpr unsigned kMostLevels = 7;  // 16^8 points

// How far the boxes of a node above level 0 reach in its frame, most of them.
inline constexpr double kReachAbove = 0x1p+16;

// How far a box in a node's frame reaches beyond the points in it, on every side, where its border
// is within [-1, 1]; relative to the border, where it is outside.
inline constexpr double kBoxMargin = 0x1p-20;

// Walks take places that are farther away, in the frame of a node, for places that are this far.
inline constexpr double kFarthest = 0x1p+61;

struct alignas(64) TreeNode {
  float low[3][kFanOut];  // of missing children: low = infinity, high = -infinity
  float high[3][kFanOut];
  double origin[3];
  double scale;
  std::uint32_t same_place;  // bit c: all points of child c are at one place
};

struct alignas(64) TreeLeaf {
  float at[3][kFanOut];  // infinity where there is no point, or no longer one
  PointId ids[kFanOut];
};

// Of the given doubles, for what floats leave open.
struct TreeBox {
  double low[3];
  double high[3];
};

// A tree as its walks see it. Slot s is place s % 16 of leaf s / 16. Where all points of a child
// are at one place, its first slot has the lowest of their ids.
struct TreeView {
  const TreeNode* levels[kMostLevels];
  const TreeBox* boxes[kMostLevels];  // of the children of the nodes of each level
  const TreeLeaf* leaves;
  const Point* points;  // the given doubles, by slot
  unsigned top;         // the root is levels[top][0]
};

class PointTree {
 public:
  // Builds the tree of `points`, all in the domain and at least one; `ids[i]` is the id of point
  // i, or i itself without `ids`. Expected cost: some 80 nanoseconds a point; no input is
  // quadratic. Memory: 45 bytes a point, and 4 more while it builds.
  PointTree(const PointsView& points, const PointId* ids, const Bounds& bounds, Crew& crew);
  // The same in memory that must outlive the tree, for one that is built again and again.
  PointTree(const PointsView& points, const Bounds& bounds, const Resources& with);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const TreeView& view() const { return view_; }

  [[nodiscard]] PointId id(std::uint32_t slot) const {
    return leaves_[slot / kFanOut].ids[slot % kFanOut];
  }
  [[nodiscard]] const Point& point(std::uint32_t slot) const { return points_[slot]; }

  // Takes a point out of all answers; its slot stays.
  void discard(std::uint32_t slot);

 private:
  class Builder;

  std::size_t size_;
  std::unique_ptr<Memory> memory_;  // its own, if any; before what it lends
  Buffer<TreeNode> nodes_;
  Buffer<TreeLeaf> leaves_;
  Buffer<TreeBox> boxes_;  // of the leaves, then of the nodes
  Buffer<Point> points_;
  TreeView view_{};
};

}  // namespace beespace::core
