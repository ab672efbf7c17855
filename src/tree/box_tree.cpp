#include "tree/box_tree.hpp"

#include "tree/point_tree_order.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace beespace::core {

namespace {

constexpr double kNoPlace = std::numeric_limits<double>::infinity();

}  // namespace

BoxTree::BoxTree(const PointsView& points, const Resources& with) : size_(points.size()) {
  {
    Buffer<TreeLeaf> leaves(with.memory, nodes(1));
    Buffer<Point> slots(with.memory, nodes(1) * kFanOut);
    order_ = point_tree_order(points, *measure(points, with), with, leaves, slots);
    static_assert(sizeof(Leaf) == kFanOut * sizeof(Point));
    leaves_ = std::move(slots).reused_as<Leaf>();
  }
  std::size_t all = size_;
  while (nodes(top_) > 1) {
    first_of_level_[++top_] = all;
    all += nodes(top_);
  }
  if (top_ < 2) first_of_level_[2] = all;
  boxes_ = Buffer<Bounds>(with.memory, all - size_);
  rows_ = Buffer<Row>(with.memory, all - first_of_level_[2]);
  with.crew.split(nodes(1), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) fill_leaf(points, leaf);
  });
  for (unsigned level = 1; level <= top_; ++level) {
    with.crew.split(nodes(level), [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) {
        Bounds around = kNoBox;
        for_each_child({level, i}, [&](const BoxNode& child) { extend(around, box(child)); });
        boxes_[number({level, i}) - size_] = around;
        if (level > 1) fill_row({level, i});
      }
    });
  }
}

void BoxTree::fill_leaf(const PointsView& points, std::size_t index) {
  Leaf& leaf = leaves_[index];
  for (std::size_t place = 0; place < kFanOut; ++place) {
    const std::size_t slot = index * kFanOut + place;
    const Point point = slot < size_ ? points[order_[slot]] : Point{kNoPlace, kNoPlace, kNoPlace};
    leaf.at[place] = point.x;
    leaf.at[kFanOut + place] = point.y;
    leaf.at[2 * kFanOut + place] = point.z;
  }
}

void BoxTree::fill_row(const BoxNode& node) {
  Row& row = rows_[number(node) - first_of_level_[2]];
  std::fill(std::begin(row.low), std::end(row.low), kNoPlace);
  std::fill(std::begin(row.high), std::end(row.high), -kNoPlace);
  std::size_t place = 0;
  for_each_child(node, [&](const BoxNode& child) {
    const Bounds of_child = box(child);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      row.low[axis * kFanOut + place] = of_child.low[axis];
      row.high[axis * kFanOut + place] = of_child.high[axis];
    }
    ++place;
  });
}

}  // namespace beespace::core
