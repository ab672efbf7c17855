#include "sweep/box_counts.hpp"

#include "base/buffer.hpp"
#include "base/dynamic_schedule.hpp"
#include "sweep/line_counts.hpp"
#include "tree/box_tree.hpp"

#include <algorithm>
#include <bit>
#include <optional>

namespace beespace::cpu {

namespace {

using core::BoxNode;
using core::BoxTree;

using BoxNumbers = core::Buffer<std::uint32_t>;  // by the numbers of nodes

// Leaves are added to as a whole, also where the last one has no points.
BoxNumbers box_zeros(const BoxTree& tree, core::Memory& memory) {
  BoxNumbers numbers(memory, tree.node_count() + core::kFanOut);
  std::fill_n(numbers.data(), tree.node_count() + core::kFanOut, 0U);
  return numbers;
}

// How many points there are in nodes.
class BoxWeights {
 public:
  BoxWeights(const BoxTree& tree, const std::uint32_t* weights, core::Memory& memory)
      : of_nodes_(box_zeros(tree, memory)), are_one_(weights == nullptr) {
    for (std::size_t slot = 0; slot < tree.size(); ++slot) {
      of_nodes_[slot] = are_one_ ? 1 : weights[tree.index(slot)];
    }
    for (unsigned level = 1; level <= tree.root().level; ++level) {
      for (std::size_t i = 0; i < tree.nodes(level); ++i) {
        tree.for_each_child({level, i}, [&](const BoxNode& child) {
          of_nodes_[tree.number({level, i})] += of_nodes_[tree.number(child)];
        });
      }
    }
  }

  [[nodiscard]] std::uint32_t of(std::size_t number) const { return of_nodes_[number]; }
  [[nodiscard]] const std::uint32_t* of_slots() const { return of_nodes_.data(); }
  // Null where all points are one each.
  [[nodiscard]] const std::uint32_t* of_leaf(std::size_t leaf) const {
    return are_one_ ? nullptr : of_nodes_.data() + leaf * core::kFanOut;
  }

 private:
  BoxNumbers of_nodes_;
  bool are_one_;
};

struct BoxSide {
  BoxSide(const Places& places, const core::Resources& with)
      : tree(places.points, with), weights(tree, places.weights, with.memory) {}

  BoxTree tree;
  BoxWeights weights;
};

// What one worker has found: what is noted for a node is so for each of its points. Of two sets,
// only the asked are told; of a set with itself, both of a pair.
class BoxCounts {
 public:
  static constexpr bool kTakesLeaves = true;

  BoxCounts(const BoxSide& asked, const BoxSide& others, const BoxQuery& question, BoxNumbers& sums,
            core::Memory& memory)
      : asked_(asked),
        others_(others),
        both_(&asked == &others),
        closer_(question.closer),
        reach_(question.threshold, question.closer),
        limits_{reach_.surely_near(), reach_.surely_far()},
        kernels_(box_kernels(question.instruction_set)),
        sums_(sums),
        line_(question.threshold, question.closer, memory) {}

  [[nodiscard]] bool is_settled(const BoxNode&, const BoxNode&) const { return false; }
  void open(const BoxNode&) const {}
  void close(const BoxNode&) const {}

  void take_near(const BoxNode& a, const BoxNode& b) {
    add(asked(), asked_.tree.number(a), others(), others_.tree.number(b));
  }
  void take_all(const BoxNode& a) {
    sums_[asked_.tree.number(a)] += asked_.weights.of(asked_.tree.number(a));
  }

  // Each pair is seen from both sides, so one side is told.
  void take_within(const BoxNode& a) {
    compare({asked_, nullptr}, lanes(asked_.tree, a), {asked_, sums_.data()},
            lanes(asked_.tree, a));
  }
  void take_leaves(const BoxNode& a, const BoxNode& b) {
    // The kernel looks at all lanes of the second.
    if (b.level == 0) {
      compare(others(), lanes(others_.tree, b), asked(), lanes(asked_.tree, a));
    } else {
      compare(asked(), lanes(asked_.tree, a), others(), lanes(others_.tree, b));
    }
  }
  [[nodiscard]] bool take_along(const BoxNode& a, const core::Bounds& own, const BoxNode& b,
                                const core::Bounds& other) {
    if (!line_.suits(own, other)) return false;
    return line_.count(line_side(asked(), a), line_side(others(), b));
  }
  void take_points(const BoxNode& a, const BoxNode& b) {
    count_points(asked(), lanes(asked_.tree, a), others(), b);
  }
  void take_others(const BoxNode& a, const BoxNode& b) {
    count_points(others(), lanes(others_.tree, b), asked(), a);
  }

 private:
  // One of the two sets, and its sums by the numbers of nodes; null: they are not wanted.
  struct Part {
    const BoxSide& side;
    std::uint32_t* sums;
  };
  // A leaf, and those of its points that are asked about, a bit each.
  struct Lanes {
    std::size_t leaf;
    std::uint32_t rows;

    [[nodiscard]] std::size_t slot(std::uint32_t lane) const { return leaf * core::kFanOut + lane; }
  };

  [[nodiscard]] Part asked() const { return {asked_, sums_.data()}; }
  [[nodiscard]] Part others() const { return {others_, both_ ? sums_.data() : nullptr}; }

  static LineSide line_side(const Part& part, const BoxNode& node) {
    return {part.side.tree, node, part.side.weights.of_slots(), part.sums};
  }

  static Lanes lanes(const BoxTree& tree, const BoxNode& node) {
    if (node.level == 0) {
      return {node.index / core::kFanOut, 1U << (node.index % core::kFanOut)};
    }
    const std::size_t count = tree.end_slot(node) - tree.first_slot(node);
    return {node.index, (1U << count) - 1};
  }

  // Each of some points of a leaf with a node that is open to them, sixteen children at a time.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as trees
  void count_points(const Part& one, const Lanes& points, const Part& two, const BoxNode& node) {
    if (node.level <= 1) return compare(one, points, two, lanes(two.side.tree, node));
    if (core::is_stopping()) return;
    const BoxTree& tree = two.side.tree;
    const BoxNode first = tree.first_child(node);
    const BoxRow row{tree.low_corners(node), tree.high_corners(node)};
    std::uint32_t open[core::kFanOut] = {};  // by child: the points to which it is open
    std::uint32_t some = 0;
    for (std::uint32_t left = points.rows; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
      const std::size_t slot = points.slot(lane);
      const core::Bounds place = core::box_around(one.side.tree.point(slot));
      BoxesAround seen = kernels_.look(place.low.data(), place.high.data(), row, limits_);
      for (std::uint32_t unsure = seen.unsure; unsure != 0; unsure &= unsure - 1) {
        const auto child = static_cast<std::size_t>(std::countr_zero(unsure));
        const core::Reach reach = reach_(place, tree.box({first.level, first.index + child}));
        if (reach == core::Reach::kNear) seen.near |= 1U << child;
        if (reach == core::Reach::kOpen) seen.open |= 1U << child;
      }
      for (std::uint32_t near = seen.near; near != 0; near &= near - 1) {
        const auto child = static_cast<std::size_t>(std::countr_zero(near));
        add(one, slot, two, tree.number({first.level, first.index + child}));
      }
      for (std::uint32_t within = seen.open; within != 0; within &= within - 1) {
        open[std::countr_zero(within)] |= 1U << lane;
      }
      some |= seen.open;
    }
    for (; some != 0; some &= some - 1) {
      const auto child = static_cast<std::size_t>(std::countr_zero(some));
      count_points(one, {points.leaf, open[child]}, two, {first.level, first.index + child});
    }
  }

  // All points of two nodes are near to each other; by their numbers.
  static void add(const Part& one, std::size_t number, const Part& two, std::size_t other) {
    if (one.sums != nullptr) one.sums[number] += two.side.weights.of(other);
    if (two.sums != nullptr) two.sums[other] += one.side.weights.of(number);
  }

  // Some points of a leaf with all of another.
  void compare(const Part& one, const Lanes& points, const Part& two, const Lanes& others) {
    std::uint16_t unsure[core::kFanOut];
    std::uint32_t unused[2 * core::kFanOut] = {};
    const BoxLeaves leaves{one.side.tree.leaf(points.leaf),
                           two.side.tree.leaf(others.leaf),
                           points.rows,
                           one.side.weights.of_leaf(points.leaf),
                           two.side.weights.of_leaf(others.leaf),
                           one.sums == nullptr ? unused : one.sums + points.slot(0),
                           two.sums == nullptr ? unused + core::kFanOut : two.sums + others.slot(0),
                           unsure};
    if (!kernels_.count(leaves, limits_)) return;
    for (std::uint32_t rows = points.rows; rows != 0; rows &= rows - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(rows));
      for (std::uint32_t left = unsure[lane]; left != 0; left &= left - 1) {
        const std::size_t slot = points.slot(lane);
        const std::size_t other = others.slot(static_cast<std::uint32_t>(std::countr_zero(left)));
        if (!closer_(one.side.tree.point(slot), two.side.tree.point(other))) continue;
        add(one, slot, two, other);
      }
    }
  }

  const BoxSide& asked_;
  const BoxSide& others_;
  bool both_;
  const core::ProximityTest& closer_;
  core::BoxTest reach_;
  BoxLimits limits_;
  const BoxKernels& kernels_;
  BoxNumbers& sums_;
  LineCounts line_;
};

using BoxSums = core::Vector<std::optional<BoxNumbers>>;

void write_box_counts(const BoxTree& tree, const BoxSums& sums, const core::Resources& with,
                      std::uint32_t* counts) {
  with.crew.split(tree.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      std::uint32_t count = 0;
      for (const std::optional<BoxNumbers>& of_worker : sums) {
        if (!of_worker) continue;
        for (unsigned level = 0; level <= tree.root().level; ++level) {
          count += (*of_worker)[tree.number({level, slot >> (4 * level)})];
        }
      }
      counts[tree.index(slot)] = count;
    }
  });
}

// Every node of the asked is one worker's alone.
void count_between(const BoxSide& asked, const BoxSide& others, const BoxQuery& question,
                   const core::Resources& with, BoxSums& sums) {
  sums[0].emplace(box_zeros(asked.tree, with.memory));
  const unsigned level = asked.tree.level_with(enough_for(with));
  schedule(with.crew, asked.tree.nodes(level), 1, [&](std::size_t i, std::size_t, unsigned worker) {
    BoxCounts task(asked, others, question, *sums[0], with.memory.of(worker));
    BoxJoin(asked.tree, others.tree, question, task).join({level, i}, others.tree.root());
  });
}

void count_among(const BoxSide& all, const BoxQuery& question, const core::Resources& with,
                 BoxSums& sums) {
  const unsigned level = all.tree.level_with(enough_for(with));
  const std::size_t nodes = all.tree.nodes(level);
  schedule(with.crew, nodes, 1, [&](std::size_t i, std::size_t, unsigned worker) {
    if (!sums[worker]) sums[worker].emplace(box_zeros(all.tree, with.memory));
    BoxCounts task(all, all, question, *sums[worker], with.memory.of(worker));
    BoxJoin join(all.tree, all.tree, question, task);
    join.join_within({level, i});
    for (std::size_t other = i + 1; other < nodes; ++other) join.join({level, i}, {level, other});
  });
}

}  // namespace

void count_in_boxes(const Places& points, const Places* others, const BoxQuery& question,
                    const core::Resources& with, std::uint32_t* counts) {
  const BoxSide asked(points, with);
  BoxSums sums(with.crew.size(), &with.memory);
  if (others == nullptr) {
    count_among(asked, question, with, sums);
  } else {
    const BoxSide around(*others, with);
    count_between(asked, around, question, with, sums);
  }
  write_box_counts(asked.tree, sums, with, counts);
}

}  // namespace beespace::cpu
