// Walks along the pairs of two trees of boxes, as few of them as possible.
#pragma once

#include "base/stopping.hpp"
#include "tree/box_test.hpp"
#include "tree/box_tree.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::core {

// Tells a task which nodes are near as a whole: their points are the pairs closer than the
// threshold, each pair once. Of two boxes that are open, the one with the longer side is opened, so
// a clump is compared as a whole with each point that is far for its size.
//
// Task has
//   is_settled(a, b)   whether the pair need not be looked at
//   take_near(a, b)    all points of a are near to all points of b
//   open(a), close(a)  around a walk through the children of a node of the first tree, or of both
template <class Task>
class BoxJoin {
 public:
  BoxJoin(const BoxTree& first, const BoxTree& second, const BoxTest& reach, Task& task)
      : first_(first), second_(second), reach_(reach), task_(task) {}

  void join(const BoxNode& a, const BoxNode& b) {  // NOLINT(misc-no-recursion): as deep as trees
    if (task_.is_settled(a, b) || is_stopping()) return;
    const Bounds own = first_.box(a);
    const Bounds other = second_.box(b);
    const Reach reach = reach_(own, other);
    if (reach == Reach::kFar) return;
    if (reach == Reach::kNear) return task_.take_near(a, b);
    // Of two points, nothing is open.
    if (a.level != 0 && (b.level == 0 || longest_side(own) >= longest_side(other))) {
      task_.open(a);
      first_.for_each_child(a, [&](const BoxNode& child) { join(child, b); });
      task_.close(a);
    } else {
      task_.open(b);
      second_.for_each_child(b, [&](const BoxNode& child) { join(a, child); });
    }
  }

  // The same of the pairs within a node, where both trees are one.
  void join_within(const BoxNode& a) {  // NOLINT(misc-no-recursion)
    if (a.level == 0 || is_stopping()) return;
    if (reach_(first_.box(a), first_.box(a)) == Reach::kNear) return task_.take_near(a, a);
    task_.open(a);
    first_.for_each_child(a, [&](const BoxNode& child) {
      join_within(child);
      first_.for_each_child(a, [&](const BoxNode& before) {
        if (before.index < child.index) join(before, child);
      });
    });
    task_.close(a);
  }

 private:
  static double longest_side(const Bounds& box) {
    double longest = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      longest = std::max(longest, box.high[axis] - box.low[axis]);
    }
    return longest;
  }

  const BoxTree& first_;
  const BoxTree& second_;
  const BoxTest& reach_;
  Task& task_;
};

}  // namespace beespace::core
