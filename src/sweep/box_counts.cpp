#include "sweep/box_counts.hpp"

#include "base/buffer.hpp"
#include "base/dynamic_schedule.hpp"
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

  BoxCounts(const BoxSide& asked, const BoxSide& others, const BoxQuery& question, BoxNumbers& sums)
      : asked_(asked),
        others_(others),
        both_(&asked == &others),
        closer_(question.closer),
        limits_{0.0, 0.0},
        kernels_(box_kernels(question.instruction_set)),
        sums_(sums) {
    const core::BoxTest test(question.threshold, question.closer);
    limits_ = {test.surely_near(), test.surely_far()};
  }

  [[nodiscard]] bool is_settled(const BoxNode&, const BoxNode&) const { return false; }
  void open(const BoxNode&) const {}
  void close(const BoxNode&) const {}

  void take_near(const BoxNode& a, const BoxNode& b) {
    const std::size_t asked = asked_.tree.number(a);
    const std::size_t other = others_.tree.number(b);
    sums_[asked] += others_.weights.of(other);
    if (both_) sums_[other] += asked_.weights.of(asked);
  }
  void take_all(const BoxNode& a) {
    sums_[asked_.tree.number(a)] += asked_.weights.of(asked_.tree.number(a));
  }

  // Each pair is seen from both sides, so one side is told.
  void take_within(const BoxNode& a) {
    const Range all = lanes(asked_.tree, a);
    std::uint32_t unused[core::kFanOut] = {};
    compare({asked_, all, unused}, {asked_, all, sums_.data() + all.first_slot});
  }
  void take_leaves(const BoxNode& a, const BoxNode& b) {
    std::uint32_t unused[core::kFanOut] = {};
    const Range of_asked = lanes(asked_.tree, a);
    const Range of_others = lanes(others_.tree, b);
    const BoxPart asked{asked_, of_asked, sums_.data() + of_asked.first_slot};
    const BoxPart others{others_, of_others, both_ ? sums_.data() + of_others.first_slot : unused};
    // The kernel looks at all lanes of the second.
    if (b.level == 0) {
      compare(others, asked);
    } else {
      compare(asked, others);
    }
  }

 private:
  // A leaf, and those of its lanes that are asked about.
  struct Range {
    std::size_t leaf;
    std::size_t first_slot;  // of the leaf
    std::uint32_t begin;
    std::uint32_t end;
  };
  struct BoxPart {
    const BoxSide& side;
    Range range;
    std::uint32_t* sums;  // by lane
  };

  static Range lanes(const BoxTree& tree, const BoxNode& node) {
    const std::size_t leaf = node.level == 0 ? node.index / core::kFanOut : node.index;
    const std::size_t first_slot = leaf * core::kFanOut;
    return {leaf, first_slot, static_cast<std::uint32_t>(tree.first_slot(node) - first_slot),
            static_cast<std::uint32_t>(tree.end_slot(node) - first_slot)};
  }

  void compare(const BoxPart& one, const BoxPart& two) {
    std::uint16_t unsure[core::kFanOut];
    const Range& range = one.range;
    const BoxLeaves leaves{one.side.tree.leaf(range.leaf),
                           two.side.tree.leaf(two.range.leaf),
                           range.begin,
                           range.end,
                           one.side.weights.of_leaf(range.leaf),
                           two.side.weights.of_leaf(two.range.leaf),
                           one.sums,
                           two.sums,
                           unsure};
    if (!kernels_.count(leaves, limits_)) return;
    for (std::uint32_t lane = range.begin; lane < range.end; ++lane) {
      for (std::uint32_t left = unsure[lane]; left != 0; left &= left - 1) {
        decide(one, lane, two, static_cast<std::uint32_t>(std::countr_zero(left)));
      }
    }
  }

  void decide(const BoxPart& one, std::uint32_t lane, const BoxPart& two, std::uint32_t other) {
    const std::size_t slot = one.range.first_slot + lane;
    const std::size_t other_slot = two.range.first_slot + other;
    if (!closer_(one.side.tree.point(slot), two.side.tree.point(other_slot))) return;
    one.sums[lane] += two.side.weights.of(other_slot);
    two.sums[other] += one.side.weights.of(slot);
  }

  const BoxSide& asked_;
  const BoxSide& others_;
  bool both_;
  const core::ProximityTest& closer_;
  BoxLimits limits_;
  const BoxKernels& kernels_;
  BoxNumbers& sums_;
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
  schedule(with.crew, asked.tree.nodes(level), 1, [&](std::size_t i, std::size_t, unsigned) {
    BoxCounts task(asked, others, question, *sums[0]);
    BoxJoin(asked.tree, others.tree, question, task).join({level, i}, others.tree.root());
  });
}

void count_among(const BoxSide& all, const BoxQuery& question, const core::Resources& with,
                 BoxSums& sums) {
  const unsigned level = all.tree.level_with(enough_for(with));
  const std::size_t nodes = all.tree.nodes(level);
  schedule(with.crew, nodes, 1, [&](std::size_t i, std::size_t, unsigned worker) {
    if (!sums[worker]) sums[worker].emplace(box_zeros(all.tree, with.memory));
    BoxCounts task(all, all, question, *sums[worker]);
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
