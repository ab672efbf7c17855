// Points in the order of their directions from a centre, and how far the nodes of this order are
// from places near the centre: told better than by boxes where points lie on a shell around it, as
// its boxes are thick wherever it is oblique.
//
// Directions are those of the faces of a cube, on each along a curve of Hilbert: so sixteen points
// that stand together make a leaf, sixteen leaves a node of level 0, and so on, all compact.
//
// Of each child of a node, seen from the centre c: the least |p - c|^2 of its points; a direction n
// towards their middle; the least and the greatest n (p - c); and how far aside of the axis along n
// they lie at most. With v = q - c, of any of these points,
//   |q - p|^2 = |p - c|^2 - 2 v (p - c) + |v|^2,
//   v (p - c) <= max(vn low, vn high) + |v - vn n| aside,  vn = v n.
// On a shell around c, that is right but for the width of the child aside times the sine between v
// and n: next to nothing for those that are nearest to q.
//
// All is in doubles, u = 2^-53. Differences, squares and products are off by a few u of |p - c|^2 +
// |v|^2 (as 2 |v| |p - c| is no more), as is what follows from a direction whose length is not
// quite
// 1. `least` is 2^-44 of the greatest |p - c|^2 too small, and |v|^2 is taken 2^-44 too small,
// which is many times as much. Only the root of |v|^2 - vn^2 may be off by more, so 2^-48 |v|^2 is
// added before it is taken.
#pragma once

#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "tree/point_tree.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <cstddef>
#include <cstdint>

namespace beespace::core {

// Of sixteen children, by lane; where there is none, `least` is infinite and the others are 0.
struct alignas(64) ShellRow {
  double towards[3][kFanOut];
  double least[kFanOut];
  double low[kFanOut];
  double high[kFanOut];
  double aside[kFanOut];
};

class ShellTree {
 public:
  // Of at least one point. Memory: 56 bytes a point, and 16 more while it builds.
  ShellTree(const PointsView& points, const Point& centre, const Resources& with);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Point& centre() const { return centre_; }
  [[nodiscard]] unsigned top() const { return top_; }  // the root is node 0 of this level
  [[nodiscard]] const ShellRow& row(unsigned level, std::size_t node) const {
    return rows_[first_of_level_[level] + node];
  }
  // Sixteen points, as box_kernels.hpp wants them: [axis * kFanOut + lane], infinite where there is
  // none.
  [[nodiscard]] const double* leaf(std::size_t index) const { return leaves_[index].at; }
  [[nodiscard]] const Point& point(std::size_t slot) const { return points_[slot]; }
  // Which of the view's points is in a slot.
  [[nodiscard]] PointId id(std::size_t slot) const { return ids_[slot]; }

 private:
  struct Leaf {
    double at[3 * kFanOut];
  };

  [[nodiscard]] std::size_t nodes(unsigned level) const {
    return ((size_ - 1) >> (4 * (level + 2))) + 1;
  }
  [[nodiscard]] std::size_t leaf_count() const { return (size_ - 1) / kFanOut + 1; }
  void sort(const PointsView& points, const Resources& with);
  void fill(ShellRow& row, unsigned level, std::size_t node) const;
  void fill_child(ShellRow& row, std::size_t lane, std::size_t begin, std::size_t end) const;

  std::size_t size_;
  Point centre_;
  unsigned top_ = 0;
  std::size_t first_of_level_[kMostLevels] = {};
  Buffer<Point> points_;
  Buffer<Leaf> leaves_;
  Buffer<PointId> ids_;
  Buffer<ShellRow> rows_;
};

}  // namespace beespace::core
