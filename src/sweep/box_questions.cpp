#include "sweep/box_questions.hpp"

#include "base/buffer.hpp"
#include "base/dynamic_schedule.hpp"

#include <algorithm>
#include <atomic>

namespace beespace::cpu {

namespace {

using core::BoxNode;
using core::BoxTree;

template <class Number>
core::Buffer<Number> zeros(std::size_t size, core::Memory& memory) {
  core::Buffer<Number> numbers(memory, size);
  std::fill_n(numbers.data(), size, Number{0});
  return numbers;
}

// Each node of the first tree is one worker's alone.
class BoxMarks {
 public:
  BoxMarks(const BoxTree& asked, core::Memory& memory)
      : asked_(asked), marked_(zeros<std::uint8_t>(asked.node_count(), memory)) {}

  [[nodiscard]] bool is_settled(const BoxNode& a, const BoxNode&) const {
    return marked_[asked_.number(a)] != 0;
  }
  void take_near(const BoxNode& a, const BoxNode&) {
    std::fill(marked_.data() + asked_.first_slot(a), marked_.data() + asked_.end_slot(a),
              std::uint8_t{1});
    marked_[asked_.number(a)] = 1;
  }
  void take_all(const BoxNode&) const {}
  static constexpr bool kTakesLeaves = false;
  void open(const BoxNode&) const {}
  void close(const BoxNode& a) {
    bool all = true;
    asked_.for_each_child(a, [&](const BoxNode& child) { all &= is_settled(child, child); });
    if (all) marked_[asked_.number(a)] = 1;
  }

  [[nodiscard]] std::uint8_t of_slot(std::size_t slot) const { return marked_[slot]; }

 private:
  const BoxTree& asked_;
  core::Buffer<std::uint8_t> marked_;  // by the numbers of nodes: whether all of their points are
};

// What is noted is true of the sets when all work is done, so no worker waits for another's note.
class BoxGroups {
 public:
  BoxGroups(const BoxTree& tree, core::DisjointSets& sets, core::Memory& memory)
      : tree_(tree), sets_(sets), united_(zeros<std::uint8_t>(tree.node_count(), memory)) {}

  [[nodiscard]] bool is_settled(const BoxNode& a, const BoxNode& b) {
    return is_united(a) && is_united(b) && are_one(a, b);
  }
  void take_near(const BoxNode& a, const BoxNode& b) {
    unite(a);
    unite(b);
    sets_.join(first(a), first(b));
  }
  void take_all(const BoxNode& a) { unite(a); }
  static constexpr bool kTakesLeaves = false;
  // What is part of one set is so in each of its parts.
  void open(const BoxNode& a) {
    if (!is_united(a)) return;
    tree_.for_each_child(a, [&](const BoxNode& child) { note_united(child); });
  }
  void close(const BoxNode& a) {
    bool united = true;
    tree_.for_each_child(
        a, [&](const BoxNode& child) { united = united && is_united(child) && are_one(a, child); });
    if (united) note_united(a);
  }

 private:
  [[nodiscard]] std::uint32_t first(const BoxNode& node) const {
    return static_cast<std::uint32_t>(tree_.first_slot(node));
  }
  [[nodiscard]] bool are_one(const BoxNode& a, const BoxNode& b) {
    return sets_.root(first(a)) == sets_.root(first(b));
  }
  [[nodiscard]] bool is_united(const BoxNode& node) {
    return node.level == 0 || std::atomic_ref<std::uint8_t>(united_[tree_.number(node)])
                                      .load(std::memory_order_relaxed) != 0;
  }
  void note_united(const BoxNode& node) {
    std::atomic_ref<std::uint8_t>(united_[tree_.number(node)]).store(1, std::memory_order_relaxed);
  }
  void unite(const BoxNode& node) {
    if (is_united(node)) return;
    for (std::size_t slot = tree_.first_slot(node) + 1; slot < tree_.end_slot(node); ++slot) {
      sets_.join(first(node), static_cast<std::uint32_t>(slot));
    }
    note_united(node);
  }

  const BoxTree& tree_;
  core::DisjointSets& sets_;
  core::Buffer<std::uint8_t> united_;  // by the numbers of nodes: whether known to be of one set
};

}  // namespace

void mark_in_boxes(const PointsView& points, const PointsView& others, const BoxQuery& question,
                   const core::Resources& with, std::uint8_t* at_risk) {
  const BoxTree asked(points, with);
  const BoxTree around(others, with);
  BoxMarks task(asked, with.memory);
  const unsigned level = asked.level_with(enough_for(with));
  schedule(with.crew, asked.nodes(level), 1, [&](std::size_t begin, std::size_t, unsigned) {
    BoxJoin(asked, around, question, task).join({level, begin}, around.root());
  });
  with.crew.split(asked.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      at_risk[asked.index(slot)] = task.of_slot(slot);
    }
  });
}

void join_in_boxes(const BoxTree& tree, const BoxQuery& question, const core::Resources& with,
                   core::DisjointSets& sets) {
  BoxGroups task(tree, sets, with.memory);
  const unsigned level = tree.level_with(enough_for(with));
  const std::size_t nodes = tree.nodes(level);
  schedule(with.crew, nodes, 1, [&](std::size_t begin, std::size_t, unsigned) {
    BoxJoin(tree, tree, question, task).join_within({level, begin});
  });
  schedule(with.crew, nodes, 1, [&](std::size_t begin, std::size_t, unsigned) {
    BoxJoin join(tree, tree, question, task);
    for (std::size_t other = begin + 1; other < nodes; ++other) {
      join.join({level, begin}, {level, other});
    }
  });
}

}  // namespace beespace::cpu
