#include "tree/point_tree.hpp"

#include "tree/box_tree.hpp"
#include "tree/point_tree_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace beespace::core {

namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();

std::size_t groups_of(std::size_t count) {
  return (count + kFanOut - 1) / kFanOut;
}

bool is_one_place(const Bounds& bounds) {
  return bounds.low == bounds.high;
}

double middle_of(double low, double high) {
  return low + (high - low) / 2;
}

// The largest power of two by which a distance becomes at most 1; any for zero.
double scale_for(double distance) {
  int exponent = 0;
  (void)std::frexp(distance, &exponent);  // distance < 2^exponent
  return std::ldexp(1.0, -exponent);
}

double reach_from(const double* origin, const Bounds& box) {
  double reach = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    reach = std::max({reach, box.high[axis] - origin[axis], origin[axis] - box.low[axis]});
  }
  return reach;
}

// All of the box in [-1, 1].
void set_frame_around(TreeNode& node, const Bounds& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.origin[axis] = middle_of(box.low[axis], box.high[axis]);
  }
  node.scale = scale_for(reach_from(node.origin, box));
}

// Most of the boxes in [-kReachAbove, kReachAbove]: one far away does not blur the others. Floats
// tell a small box from the large ones around it by as many digits more, as the distances of boxes
// are as good as their own size.
void set_frame_among(TreeNode& node, const Bounds* boxes, std::size_t count) {
  std::array<double, kFanOut> values{};
  const auto median = values.begin() + count / 2;
  const auto end = values.begin() + count;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t box = 0; box < count; ++box) {
      values[box] = middle_of(boxes[box].low[axis], boxes[box].high[axis]);
    }
    std::nth_element(values.begin(), median, end);
    node.origin[axis] = *median;
  }
  for (std::size_t box = 0; box < count; ++box) values[box] = reach_from(node.origin, boxes[box]);
  std::nth_element(values.begin(), median, end);
  node.scale = scale_for(*median) * kReachAbove;
}

// The lower border of a box as walks may see it: a margin farther out, and so that it does not
// matter that they look no farther than kFarthest.
float low_border(double local) {
  constexpr double kFar = kFarthest / 2;
  const double border = local - kBoxMargin * std::max(1.0, std::abs(local));
  if (border < -kFar) return -kNowhere;
  return static_cast<float>(std::min(border, kFar));
}

float high_border(double local) {
  return -low_border(-local);
}

// Writes the boxes of the children into the node, in its frame.
void set_children(TreeNode& node, const Bounds* children, std::size_t count) {
  node.same_place = 0;
  for (std::size_t child = 0; child < count; ++child) {
    if (is_one_place(children[child])) node.same_place |= 1U << child;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = (children[child].low[axis] - node.origin[axis]) * node.scale;
      const double high = (children[child].high[axis] - node.origin[axis]) * node.scale;
      node.low[axis][child] = low_border(low);
      node.high[axis][child] = high_border(high);
    }
  }
  for (std::size_t child = count; child < kFanOut; ++child) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.low[axis][child] = kNowhere;
      node.high[axis][child] = -kNowhere;
    }
  }
}

}  // namespace

class PointTree::Builder {
 public:
  Builder(PointTree& tree, const PointsView& points, const PointId* ids, const Resources& with)
      : tree_(tree), points_(points), ids_(ids), with_(with), sorted_(&with.memory) {
    std::size_t count = groups_of(tree.size_);
    std::size_t all = 0;
    for (level_count_ = 0; level_count_ == 0 || count > 1; ++level_count_) {
      leaf_count_ = level_count_ == 0 ? count : leaf_count_;
      count = groups_of(count);
      first_[level_count_] = all;
      all += count;
    }
    first_[level_count_] = all;
    tree.nodes_ = Buffer<TreeNode>(with.memory, all);
    boxes_ = Buffer<Bounds>(with.memory, all);
    tree.boxes_ = Buffer<TreeBox>(with.memory, leaf_count_ + all);
    tree.leaves_ = Buffer<TreeLeaf>(with.memory, leaf_count_);
    tree.points_ = Buffer<Point>(with.memory, tree.size_);
    for (unsigned level = 0; level < level_count_; ++level) {
      tree.view_.levels[level] = tree.nodes_.data() + first_[level];
      tree.view_.boxes[level] =
          tree.boxes_.data() + (level == 0 ? 0 : leaf_count_ + first_[level - 1]);
    }
    tree.view_.leaves = tree.leaves_.data();
    tree.view_.points = tree.points_.data();
    tree.view_.top = level_count_ - 1;
  }

  void build(const Bounds& bounds) {
    const Buffer<std::uint32_t> order =
        point_tree_order(points_, bounds, with_, tree_.leaves_, tree_.points_);
    with_.crew.split(first_[1], [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t node = begin; node < end; ++node) fill_bottom(node, order.data());
    });
    for (unsigned level = 1; level < level_count_; ++level) {
      const std::size_t below = first_[level] - first_[level - 1];
      for (std::size_t node = 0; node < first_[level + 1] - first_[level]; ++node) {
        const std::size_t child = node * kFanOut;
        set_node(first_[level] + node, level, boxes_.data() + first_[level - 1] + child,
                 std::min(kFanOut, below - child));
      }
    }
    order_ids(level_count_ - 1, 0);
  }

 private:
  void set_node(std::size_t index, unsigned level, const Bounds* children, std::size_t count) {
    TreeNode& node = tree_.nodes_[index];
    boxes_[index] = kNoBox;
    for (std::size_t child = 0; child < count; ++child) extend(boxes_[index], children[child]);
    write_box(leaf_count_ + index, boxes_[index]);
    if (level == 0) {
      set_frame_around(node, boxes_[index]);
    } else {
      set_frame_among(node, children, count);
    }
    set_children(node, children, count);
  }

  void write_box(std::size_t number, const Bounds& box) {
    TreeBox& written = tree_.boxes_[number];
    std::copy(box.low.begin(), box.low.end(), written.low);
    std::copy(box.high.begin(), box.high.end(), written.high);
  }

  // A node of level 0 with its leaves and their points.
  void fill_bottom(std::size_t node, const std::uint32_t* order) {
    constexpr std::size_t kPoints = kFanOut * kFanOut;
    const std::size_t begin = node * kPoints;
    const std::size_t end = std::min(begin + kPoints, tree_.size_);
    prefetch(order, end, std::min(end + kPoints, tree_.size_));
    std::array<Bounds, kFanOut> boxes;
    const std::size_t leaves = groups_of(end - begin);
    for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
      Bounds box = kNoBox;
      const std::size_t first = begin + leaf * kFanOut;
      for (std::size_t slot = first; slot < std::min(first + kFanOut, end); ++slot) {
        tree_.points_[slot] = points_[order[slot]];
        extend(box, box_around(tree_.points_[slot]));
      }
      boxes[leaf] = box;
      write_box(node * kFanOut + leaf, box);
    }
    set_node(node, 0, boxes.data(), leaves);
    for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
      fill_leaf(tree_.nodes_[node], node * kFanOut + leaf, order);
    }
  }

  void fill_leaf(const TreeNode& node, std::size_t leaf, const std::uint32_t* order) {
    TreeLeaf& filled = tree_.leaves_[leaf];
    const std::size_t first = leaf * kFanOut;
    const std::size_t count = std::min(kFanOut, tree_.size_ - first);
    const Point* const points = tree_.points_.data() + first;
    for (std::size_t place = 0; place < count; ++place) {
      const std::array<double, 3> at{points[place].x, points[place].y, points[place].z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double local = (at[axis] - node.origin[axis]) * node.scale;
        filled.at[axis][place] = static_cast<float>(local);
      }
      const std::uint32_t index = order[first + place];
      filled.ids[place] = ids_ == nullptr ? index : ids_[index];
    }
    for (std::size_t place = count; place < kFanOut; ++place) {
      for (auto& axis : filled.at) axis[place] = kNowhere;
      filled.ids[place] = 0;
    }
  }

  void prefetch(const std::uint32_t* order, std::size_t begin, std::size_t end) const {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const auto index = static_cast<std::ptrdiff_t>(order[slot]);
      __builtin_prefetch(static_cast<const std::byte*>(points_.axes()[0]) +
                         index * points_.stride_bytes()[0]);
    }
  }

  // Where many points are at one place: the lowest id first.
  void order_ids(unsigned level, std::size_t node) {
    std::size_t children = leaf_count_;
    if (level > 0) children = first_[level] - first_[level - 1];
    const std::size_t end = std::min((node + 1) * kFanOut, children);
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): levels end at 0
    const std::size_t points_a_child = kFanOut << (4 * level);
    for (std::size_t child = node * kFanOut; child < end; ++child) {
      if ((tree_.view_.levels[level][node].same_place >> (child % kFanOut) & 1U) != 0) {
        sort_ids(child * points_a_child, std::min((child + 1) * points_a_child, tree_.size_));
      } else if (level > 0) {
        order_ids(level - 1, child);
      }
    }
  }

  // The slots change their ids, not their points: these may differ in the sign of a zero, which
  // no distance can tell.
  void sort_ids(std::size_t begin, std::size_t end) {
    sorted_.clear();
    for (std::size_t slot = begin; slot < end; ++slot) {
      sorted_.push_back(tree_.id(static_cast<std::uint32_t>(slot)));
    }
    std::sort(sorted_.begin(), sorted_.end());
    for (std::size_t slot = begin; slot < end; ++slot) {
      tree_.leaves_[slot / kFanOut].ids[slot % kFanOut] = sorted_[slot - begin];
    }
  }

  PointTree& tree_;
  const PointsView& points_;
  const PointId* ids_;
  const Resources& with_;
  unsigned level_count_ = 0;
  std::array<std::size_t, kMostLevels + 1> first_{};  // node of each level
  std::size_t leaf_count_ = 0;
  Buffer<Bounds> boxes_;  // of the nodes, exact
  Vector<PointId> sorted_;
};

PointTree::PointTree(const PointsView& points, const PointId* ids, const Bounds& bounds, Crew& crew)
    : size_(points.size()), memory_(std::make_unique<Memory>()) {
  Builder(*this, points, ids, {crew, *memory_}).build(bounds);
  memory_->release();
}

PointTree::PointTree(const PointsView& points, const Bounds& bounds, const Resources& with)
    : size_(points.size()) {
  Builder(*this, points, nullptr, with).build(bounds);
}

void PointTree::discard(std::uint32_t slot) {
  for (auto& axis : leaves_[slot / kFanOut].at) axis[slot % kFanOut] = kNowhere;
}

}  // namespace beespace::core
