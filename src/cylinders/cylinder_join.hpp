// The pairs of places that are in each other's cylinders, of one tree or of two: pairs of boxes are
// settled as a whole where possible, and looked into where not.
//
// A Task says what becomes of the pairs. It is called with
//
//   settled(a, b)     whether nothing about the places of two nodes matters any more
//   near_itself(a)    all places of a node are near each other
//   near(a, b)        all places of one node are near all of another one
//   near(i, j)        two slots are near each other; of two leaves, or of one with i < j
//   looked_into(a)    a leaf of which slots were near others
//
// and sees each pair of places once at most: a and i of the first tree, b and j of the second.
#pragma once

#include "base/stopping.hpp"
#include "cylinders/cylinder_tree.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace beespace::core {

// A node of a CylinderTree.
struct CylinderNode {
  unsigned level;
  std::size_t node;

  friend bool operator==(const CylinderNode&, const CylinderNode&) = default;
};

// `Axes` is 4 where heights are apart, and 3 otherwise.
template <std::size_t Axes, class Task>
class CylinderJoin {
 public:
  CylinderJoin(const CylinderTree& first, const CylinderTree& second, const CylinderTests& tests,
               Task& task)
      : first_(first), second_(second), tests_(tests), task_(task) {}

  // The places of a node among themselves. Of one tree.
  void itself(CylinderNode a) {
    if (first_.count(a.level, a.node) < 2 || task_.settled(a, a)) return;
    const UprightBox& box = first_.box(a.level, a.node);
    if (tests_.boxes(box, box) == Reach::kNear) return task_.near_itself(a);
    if (a.level == 0) return look_into_itself(a.node);
    const unsigned below = a.level - 1;
    const std::size_t first = first_.first_child(a.node);
    const std::size_t end = first_.end_child(a.level, a.node);
    for (std::size_t child = first; child < end; ++child) itself({below, child});
    for (std::size_t child = first; child < end; ++child) {
      for (std::size_t other = child + 1; other < end; ++other) {
        between({below, child}, {below, other});
      }
    }
  }

  // The places of a node and all behind them. Of one tree.
  void with_later(CylinderNode a) {
    std::size_t before = a.node;
    for (unsigned level = a.level; level < first_.top(); ++level) {
      const std::size_t parent = before / CylinderTree::kFanOut;
      for (std::size_t next = before + 1; next < first_.end_child(level + 1, parent); ++next) {
        between(a, {level, next});
      }
      before = parent;
    }
  }

  // The places of a node of the first tree and of a node of the second.
  void between(CylinderNode a, CylinderNode b) {
    const Reach reach = tests_.boxes(first_.box(a.level, a.node), second_.box(b.level, b.node));
    if (reach == Reach::kFar || task_.settled(a, b)) return;
    if (reach == Reach::kNear) return task_.near(a, b);
    if (a.level == 0 && b.level == 0) return look_into(a.node, b.node);
    if (a.level >= b.level) {
      const std::size_t end = first_.end_child(a.level, a.node);
      for (std::size_t child = first_.first_child(a.node); child < end; ++child) {
        between({a.level - 1, child}, b);
      }
    } else {
      const std::size_t end = second_.end_child(b.level, b.node);
      for (std::size_t child = second_.first_child(b.node); child < end; ++child) {
        between(a, {b.level - 1, child});
      }
    }
  }

 private:
  static constexpr std::size_t kLanes = UprightLeaf::kLanes;
  using Doubles [[gnu::vector_size(16)]] = double;
  using Masks [[gnu::vector_size(16)]] = std::int64_t;
  static constexpr std::size_t kWidth = 2;

  void look_into_itself(std::size_t leaf) {
    const std::size_t slot = first_.first_slot(0, leaf);
    const std::size_t count = first_.count(0, leaf);
    bool any = false;
    for (std::size_t lane = 0; lane + 1 < count; ++lane) {
      any |= compare(first_.leaf(leaf), lane, slot + lane, first_.leaf(leaf), slot, lane + 1);
    }
    if (any) task_.looked_into({0, leaf});
  }

  void look_into(std::size_t a, std::size_t b) {
    const std::size_t slot_a = first_.first_slot(0, a);
    const std::size_t slot_b = second_.first_slot(0, b);
    const std::size_t count = first_.count(0, a);
    const UprightLeaf& leaf = first_.leaf(a);
    const UprightBox& box = second_.box(0, b);
    bool any = false;
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (is_far(leaf, lane, box)) continue;
      any |= compare(leaf, lane, slot_a + lane, second_.leaf(b), slot_b, 0);
    }
    if (!any) return;
    task_.looked_into({0, a});
    if (&first_ == &second_) task_.looked_into({0, b});
  }

  // Whether a place is surely far from a box: the box test of a single place.
  [[nodiscard]] bool is_far(const UprightLeaf& leaf, std::size_t lane,
                            const UprightBox& box) const {
    const double height = leaf.at[0][lane];
    if (box.low[0] - height > tests_.boxes.upright()) return true;
    if (height - box.high[0] > tests_.boxes.upright()) return true;
    double squared = 0.0;
    for (std::size_t axis = 1; axis < Axes; ++axis) {
      const double at = leaf.at[axis][lane];
      const double below = box.low[axis] - at;
      const double above = at - box.high[axis];
      const double gap = below > above ? below : above;
      const double least = gap > 0.0 ? gap : 0.0;
      squared += least * least;
    }
    return squared > tests_.boxes.surely_far();
  }

  // A place and those of a leaf from lane `from` on; whether any was near.
  bool compare(const UprightLeaf& leaf, std::size_t lane, std::size_t slot,
               const UprightLeaf& others, std::size_t other_slot, std::size_t from) {
    Doubles up[kLanes / kWidth];
    Doubles squared[kLanes / kWidth];
    Masks some{};
    for (std::size_t k = 0; k < kLanes / kWidth; ++k) {
      const Doubles height = load(others.at[0] + kWidth * k) - leaf.at[0][lane];
      up[k] = height < 0.0 ? -height : height;
      squared[k] = Doubles{};
      for (std::size_t axis = 1; axis < Axes; ++axis) {
        const Doubles apart = load(others.at[axis] + kWidth * k) - leaf.at[axis][lane];
        squared[k] += apart * apart;
      }
      some |= (up[k] <= tests_.boxes.upright()) & (squared[k] <= tests_.boxes.surely_far());
    }
    if ((some[0] | some[1]) == 0) return false;
    bool any = false;
    for (std::size_t other = from; other < kLanes; ++other) {
      const double high = up[other / kWidth][other % kWidth];
      const double wide = squared[other / kWidth][other % kWidth];
      if (high > tests_.boxes.upright() || wide > tests_.boxes.surely_far()) continue;
      const bool sure = high < tests_.boxes.upright() && wide < tests_.boxes.surely_near();
      if (!sure && !tests_.places(place(leaf, lane), place(others, other))) continue;
      task_.near(slot, other_slot + other);
      any = true;
    }
    return any;
  }

  static Doubles load(const double* from) {
    Doubles values;
    std::memcpy(&values, from, sizeof values);
    return values;
  }
  static Upright place(const UprightLeaf& leaf, std::size_t lane) {
    return {{leaf.at[0][lane], leaf.at[1][lane], leaf.at[2][lane], leaf.at[3][lane]}};
  }

  const CylinderTree& first_;
  const CylinderTree& second_;
  const CylinderTests& tests_;
  Task& task_;
};

// Nodes of one level, as many as give all workers enough to do.
inline unsigned job_level(const CylinderTree& tree, unsigned workers) {
  unsigned level = tree.top();
  while (level > 0 && tree.nodes(level) < std::size_t{16} * workers) --level;
  return level;
}

// Calls job(node) with every node of a level, on all workers; `job` is made by make(worker).
template <class MakeJob>
void for_each_node(const CylinderTree& tree, unsigned level, Crew& crew, const MakeJob& make) {
  std::atomic<std::size_t> next{0};
  crew.run([&](unsigned worker) {
    auto job = make(worker);
    for (std::size_t node = next++; node < tree.nodes(level) && !is_stopping(); node = next++) {
      job(CylinderNode{level, node});
    }
  });
}

// All pairs of one tree. `task_of(worker)` makes the task of a worker, once for each of two rounds;
// `between()` is called between the two, when nodes of the job level know all about themselves.
template <std::size_t Axes, class TaskOf, class Between>
void join_itself(const CylinderTree& tree, const CylinderTests& tests, Crew& crew,
                 const TaskOf& task_of, const Between& between) {
  const unsigned level = job_level(tree, crew.size());
  const auto round = [&](bool itself) {
    for_each_node(tree, level, crew, [&](unsigned worker) {
      return [&, itself, task = task_of(worker)](CylinderNode node) mutable {
        CylinderJoin<Axes, decltype(task)> join(tree, tree, tests, task);
        itself ? join.itself(node) : join.with_later(node);
      };
    });
  };
  round(true);
  between();
  round(false);
}

// All pairs of one place of `first` and one of `second`.
template <std::size_t Axes, class TaskOf>
void join_both(const CylinderTree& first, const CylinderTree& second, const CylinderTests& tests,
               Crew& crew, const TaskOf& task_of) {
  for_each_node(first, job_level(first, crew.size()), crew, [&](unsigned worker) {
    return [&, task = task_of(worker)](CylinderNode node) mutable {
      CylinderJoin<Axes, decltype(task)> join(first, second, tests, task);
      join.between(node, {second.top(), 0});
    };
  });
}

}  // namespace beespace::core
