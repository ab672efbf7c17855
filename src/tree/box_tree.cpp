#include "tree/box_tree.hpp"

#include "tree/point_tree_order.hpp"

namespace beespace::core {

BoxTree::BoxTree(const PointsView& points, const Resources& with)
    : size_(points.size()), points_(with.memory, size_) {
  {
    Buffer<TreeLeaf> leaves(with.memory, nodes(1));
    order_ = point_tree_order(points, *measure(points, with), with, leaves, points_);
  }
  std::size_t all = size_;
  while (nodes(top_) > 1) {
    first_of_level_[++top_] = all;
    all += nodes(top_);
  }
  boxes_ = Buffer<Bounds>(with.memory, all - size_);
  with.crew.split(size_, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t slot = begin; slot < end; ++slot) points_[slot] = points[order_[slot]];
  });
  for (unsigned level = 1; level <= top_; ++level) {
    with.crew.split(nodes(level), [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) {
        Bounds around = kNoBox;
        for_each_child({level, i}, [&](const BoxNode& child) { extend(around, box(child)); });
        boxes_[number({level, i}) - size_] = around;
      }
    });
  }
}

}  // namespace beespace::core
