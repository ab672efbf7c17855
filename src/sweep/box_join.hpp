// Walks along the pairs of two trees of boxes, as few of them as possible.
#pragma once

#include "base/resources.hpp"
#include "base/stopping.hpp"
#include "exact/exact_distance.hpp"
#include "kernels/box_kernels.hpp"
#include "tree/box_test.hpp"
#include "tree/box_tree.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace beespace::cpu {

static_assert(core::kFanOut == kBoxLanes);

// What makes a pair near: `closer` is the test of the threshold.
struct BoxQuery {
  double threshold;
  const core::ProximityTest& closer;
  InstructionSet instruction_set;
};

// Enough nodes for all workers to share, of uneven weight.
inline std::size_t enough_for(const core::Resources& with) {
  return with.crew.size() == 1 ? 1 : 8 * with.crew.size();
}

// Tells a task which nodes are near as a whole: their points are the pairs closer than the
// threshold, each pair once. Of two boxes that are open, the one with the longer side is opened, so
// a clump is compared as a whole with each point that is far for its size.
//
// Task has
//   is_settled(a, b)   whether the pair need not be looked at
//   take_near(a, b)    all points of a are near to all points of b
//   take_all(a)        all points of a are near to each other
//   kTakesLeaves       whether these shall decide about points: take_leaves(a, b) about those of
//                      nodes of level 1 and 0; take_within(a) about those of one leaf, among
//                      themselves; take_points(a, b) and take_others(a, b) about each point of the
//                      leaf a, or b, and the whole other node, which is smaller than the leaf
//   take_along(a, own, b, other)   whether the task has counted the pairs of two larger nodes, with
//                      these boxes, of which some are near
//   open(a), close(a)  around a walk through the children of a node of the first tree, or of both
template <class Task>
class BoxJoin {
 public:
  BoxJoin(const core::BoxTree& first, const core::BoxTree& second, const BoxQuery& question,
          Task& task)
      : first_(first),
        second_(second),
        reach_(question.threshold, question.closer),
        limits_{reach_.surely_near(), reach_.surely_far()},
        kernels_(box_kernels(question.instruction_set)),
        task_(task) {}

  void join(const core::BoxNode& a, const core::BoxNode& b) {
    if (task_.is_settled(a, b)) return;
    join_unseen(a, first_.box(a), b, second_.box(b));
  }

  // The same of the pairs within a node, where both trees are one.
  void join_within(const core::BoxNode& a) {  // NOLINT(misc-no-recursion): as deep as trees
    if (core::is_stopping()) return;
    if (a.level == 0 || reach_(first_.box(a), first_.box(a)) == core::Reach::kNear) {
      return task_.take_all(a);
    }
    if constexpr (Task::kTakesLeaves) {
      if (a.level == 1) return task_.take_within(a);
    }
    task_.open(a);
    first_.for_each_child(a, [&](const core::BoxNode& child) {
      join_within(child);
      first_.for_each_child(a, [&](const core::BoxNode& before) {
        if (before.index < child.index) join(before, child);
      });
    });
    task_.close(a);
  }

 private:
  using BoxNode = core::BoxNode;
  using BoxTree = core::BoxTree;
  using Bounds = core::Bounds;

  // NOLINTBEGIN(misc-no-recursion)
  void join_unseen(const BoxNode& a, const Bounds& own, const BoxNode& b, const Bounds& other) {
    switch (reach_(own, other)) {
      case core::Reach::kFar:
        return;
      case core::Reach::kNear:
        return task_.take_near(a, b);
      case core::Reach::kOpen:
        return join_open(a, own, b, other);
    }
  }

  void join_open(const BoxNode& a, const Bounds& own, const BoxNode& b, const Bounds& other) {
    if (core::is_stopping()) return;
    if constexpr (Task::kTakesLeaves) {
      if (a.level <= 1 && b.level <= 1) return task_.take_leaves(a, b);
      if (a.level > 1 && b.level > 1 && task_.take_along(a, own, b, other)) return;
    }
    // Of two points, nothing is open.
    if (a.level != 0 && (b.level == 0 || longest_side(own) >= longest_side(other))) {
      if constexpr (Task::kTakesLeaves) {
        if (a.level == 1) return task_.take_points(a, b);
      }
      task_.open(a);
      for_each_around(first_, a, other,
                      [&](const BoxNode& child, std::uint32_t bit, const BoxesAround& seen) {
                        if (!task_.is_settled(child, b))
                          join_seen(child, first_.box(child), b, other, bit, seen);
                      });
      task_.close(a);
    } else {
      if constexpr (Task::kTakesLeaves) {
        if (b.level == 1) return task_.take_others(a, b);
      }
      task_.open(b);
      for_each_around(second_, b, own,
                      [&](const BoxNode& child, std::uint32_t bit, const BoxesAround& seen) {
                        if (!task_.is_settled(a, child))
                          join_seen(a, own, child, second_.box(child), bit, seen);
                      });
    }
  }

  void join_seen(const BoxNode& a, const Bounds& own, const BoxNode& b, const Bounds& other,
                 std::uint32_t bit, const BoxesAround& seen) {
    if ((seen.near & bit) != 0) return task_.take_near(a, b);
    if ((seen.open & bit) != 0) return join_open(a, own, b, other);
    join_unseen(a, own, b, other);
  }

  // Calls visit(child, bit, seen) for the children of a node that may be near to a box.
  template <class Visit>
  void for_each_around(const BoxTree& tree, const BoxNode& node, const Bounds& box,
                       const Visit& visit) {
    const BoxesAround seen =
        kernels_.look(box.low.data(), box.high.data(),
                      {tree.low_corners(node), tree.high_corners(node)}, limits_);
    const BoxNode first = tree.first_child(node);
    for (std::uint32_t left = seen.near | seen.open | seen.unsure; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      visit(BoxNode{first.level, first.index + lane}, left & ~(left - 1), seen);
    }
  }
  // NOLINTEND(misc-no-recursion)

  static double longest_side(const Bounds& box) {
    double longest = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      longest = std::max(longest, box.high[axis] - box.low[axis]);
    }
    return longest;
  }

  const BoxTree& first_;
  const BoxTree& second_;
  core::BoxTest reach_;
  BoxLimits limits_;
  const BoxKernels& kernels_;
  Task& task_;
};

}  // namespace beespace::cpu
