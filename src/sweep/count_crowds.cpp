#include "sweep/count_crowds.hpp"
#include "base/stopping.hpp"

#include "grid/near_pairs.hpp"
#include "kernels/crowd_kernels.hpp"
#include "tree/box_test.hpp"
#include "tree/box_tree.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <optional>

namespace beespace::cpu {

namespace {

using core::CrowdTree;
using core::kNodePoints;
using core::Reach;

static_assert(core::kFanOut == kCrowdLanes && core::kLeafPoints == kCrowdLanes);

using Numbers = core::Buffer<std::uint32_t>;

Numbers zeros(std::size_t size, core::Memory& memory) {
  Numbers numbers(memory, size);
  std::memset(numbers.data(), 0, size * sizeof(std::uint32_t));
  return numbers;
}

std::size_t padded_leaves(const CrowdTree& tree) {
  return tree.nodes(0) * kCrowdLanes;
}

// How many points there are in leaves and nodes.
class Weights {
 public:
  Weights(const Crowds& crowds, core::Memory& memory)
      : of_leaves_(zeros(padded_leaves(crowds.tree), memory)),
        of_nodes_(zeros(crowds.tree.node_count(), memory)) {
    const CrowdTree& tree = crowds.tree;
    for (std::size_t slot = 0; slot < tree.size(); ++slot) {
      of_leaves_[slot / kCrowdLanes] += crowds.weights == nullptr ? 1 : crowds.weights[slot];
    }
    for (std::size_t leaf = 0; leaf < padded_leaves(tree); ++leaf) {
      of_nodes_[leaf / kCrowdLanes] += of_leaves_[leaf];
    }
    for (unsigned level = 1; level <= tree.top(); ++level) {
      for (std::size_t child = 0; child < tree.nodes(level - 1); ++child) {
        of_nodes_[tree.number(level, child / core::kFanOut)] +=
            of_nodes_[tree.number(level - 1, child)];
      }
    }
  }

  [[nodiscard]] std::uint32_t of_node(std::size_t number) const { return of_nodes_[number]; }
  [[nodiscard]] const std::uint32_t* of_leaves(std::size_t node) const {
    return of_leaves_.data() + node * kCrowdLanes;
  }

 private:
  Numbers of_leaves_;
  Numbers of_nodes_;
};

// The counts of one worker: for each point, for all points of a leaf, and for all of a node.
struct Tally {
  Tally(const CrowdTree& tree, core::Memory& memory)
      : of_slots(zeros(padded_leaves(tree) * kCrowdLanes, memory)),
        of_leaves(zeros(padded_leaves(tree), memory)),
        of_nodes(zeros(tree.node_count(), memory)) {}

  Numbers of_slots;
  Numbers of_leaves;
  Numbers of_nodes;
};

class Counter {
 public:
  Counter(const CrowdQuery& question, const Weights& asked_weights, const Weights& other_weights,
          Tally& tally, core::Memory& memory)
      : question_(question),
        asked_(question.asked.tree),
        others_(question.others.tree),
        both_(&asked_ == &others_),
        asked_weights_(asked_weights),
        other_weights_(other_weights),
        boxes_(question.threshold, question.closer),
        decisions_left_(question.decisions_a_point * (asked_.size() + others_.size())),
        limits_(limits(question)),
        kernels_(crowd_kernels(question.instruction_set)),
        weighted_(question.others.weights != nullptr ? 1U : 0U),
        tally_(tally),
        of_slot_lanes_(memory, std::size_t{kNodePoints} * kCrowdLanes),
        of_leaf_lanes_(memory, std::size_t{kCrowdLanes} * kCrowdLanes) {}

  // Whether floats left more open than may be decided one by one; then counts are not complete.
  [[nodiscard]] bool gave_up() const { return gave_up_; }

  // Counts the points that the points of a node are near to; of a set with itself, among themselves
  // and the points behind them, for both.
  void count(std::size_t node) {
    node_ = node;
    std::fill_n(of_slot_lanes_.data(), kNodePoints * kCrowdLanes, 0U);
    std::fill_n(of_leaf_lanes_.data(), kCrowdLanes * kCrowdLanes, 0U);
    walk(others_.top(), 0);
    const std::size_t first = asked_.first_slot(0, node);
    const std::size_t end = asked_.end_slot(0, node);
    for (std::size_t slot = first; slot < end; ++slot) {
      tally_.of_slots[slot] += sum(of_slot_lanes_, slot - first);
    }
    for (std::size_t leaf = 0; leaf < kCrowdLanes; ++leaf) {
      tally_.of_leaves[node * kCrowdLanes + leaf] += sum(of_leaf_lanes_, leaf);
    }
  }

 private:
  static Limits limits(const CrowdQuery& question) {
    const core::SquaredLimits squared(question.threshold, question.units_per_m);
    return {squared.surely_near, squared.surely_far};
  }

  static std::uint32_t sum(const Numbers& lanes, std::size_t row) {
    std::uint32_t total = 0;
    for (std::size_t lane = 0; lane < kCrowdLanes; ++lane) total += lanes[row * kCrowdLanes + lane];
    return total;
  }

  void walk(unsigned level, std::size_t node) {
    if (gave_up()) return;
    const bool holds_own = both_ && node <= node_ >> (4 * level);
    if (holds_own && node < node_ >> (4 * level)) return;  // compared from there
    const bool own = holds_own && level == 0;
    if (own || !holds_own) {
      switch (boxes_(asked_.box(0, node_), others_.box(level, node))) {
        case Reach::kFar:
          return;
        case Reach::kNear:
          return note_all(others_.number(level, node), own);
        case Reach::kOpen:
          break;
      }
      if (!own && is_tiny(others_.box(level, node))) return count_points_near(level, node);
      if (level == 0)
        return own || !is_tiny(asked_.box(0, node_)) ? compare(node, own) : count_near_points(node);
    }
    const std::size_t end = others_.end_child(level, node);
    for (std::size_t i = others_.first_child(node); i < end; ++i) walk(level - 1, i);
  }

  void note_all(std::size_t number, bool own) {
    tally_.of_nodes[node_] += other_weights_.of_node(number);
    if (both_ && !own) tally_.of_nodes[number] += asked_weights_.of_node(node_);
  }

  // Whether floats would leave open most of what is open: then it is compared as a whole, by
  // doubles.
  [[nodiscard]] bool is_tiny(const core::Bounds& box) const {
    constexpr double kUnits = 8.0;
    double longest = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      longest = std::max(longest, box.high[axis] - box.low[axis]);
    }
    return longest * question_.units_per_m <= kUnits;
  }

  // Takes one from what may be decided one by one.
  [[nodiscard]] bool may_decide() {
    if (decisions_left_ == 0) gave_up_ = true;
    if (gave_up_) return false;
    --decisions_left_;
    return true;
  }

  // Each point of the query node with another node. To compare a point with a box is no decision:
  // it spares comparing it with the points there.
  void count_points_near(unsigned level, std::size_t node) {
    for (std::size_t slot = asked_.first_slot(0, node_); slot < asked_.end_slot(0, node_); ++slot) {
      count_near(slot, asked_.point(slot), level, node);
    }
  }
  void count_near(std::size_t slot, const Point& place, unsigned level, std::size_t node) {
    if (gave_up()) return;
    const std::size_t number = others_.number(level, node);
    switch (boxes_(core::box_around(place), others_.box(level, node))) {
      case Reach::kFar:
        return;
      case Reach::kNear:
        tally_.of_slots[slot] += other_weights_.of_node(number);
        if (both_) tally_.of_nodes[number] += weight(question_.asked, slot);
        return;
      case Reach::kOpen:
        break;
    }
    if (level == 0) {
      for (std::size_t i = others_.first_slot(0, node); i < others_.end_slot(0, node); ++i) {
        if (may_decide() && question_.closer(place, others_.point(i))) count_pair(slot, i);
      }
      return;
    }
    const std::size_t end = others_.end_child(level, node);
    for (std::size_t i = others_.first_child(node); i < end; ++i) {
      count_near(slot, place, level - 1, i);
    }
  }

  // The query node with each point of another node.
  void count_near_points(std::size_t node) {
    for (std::size_t i = others_.first_slot(0, node); i < others_.end_slot(0, node); ++i) {
      if (gave_up()) return;
      const Point place = others_.point(i);
      switch (boxes_(asked_.box(0, node_), core::box_around(place))) {
        case Reach::kFar:
          break;
        case Reach::kNear:
          tally_.of_nodes[node_] += weight(question_.others, i);
          if (both_) tally_.of_slots[i] += asked_weights_.of_node(node_);
          break;
        case Reach::kOpen:
          for (std::size_t k = asked_.first_slot(0, node_); k < asked_.end_slot(0, node_); ++k) {
            if (may_decide() && question_.closer(asked_.point(k), place)) count_pair(k, i);
          }
      }
    }
  }

  void count_pair(std::size_t asked, std::size_t other) {
    tally_.of_slots[asked] += weight(question_.others, other);
    if (both_) tally_.of_slots[other] += weight(question_.asked, asked);
  }

  static std::uint32_t weight(const Crowds& crowds, std::size_t slot) {
    return crowds.weights == nullptr ? 1U : crowds.weights[slot];
  }

  void compare(std::size_t other, bool own) {
    decisions_left_ += kDecisionsANode;
    const CrowdNode one = crowd_node(question_.asked, asked_weights_, node_);
    const CrowdNode two = crowd_node(question_.others, other_weights_, other);
    const CrowdSums sums{of_slot_lanes_.data(), of_leaf_lanes_.data(),
                         both_ ? tally_.of_slots.data() + two.first_slot : nullptr,
                         both_ ? tally_.of_leaves.data() + other * kCrowdLanes : nullptr};
    const CrowdUnsure unsure{&Counter::decide, this};
    const auto& kernels = own     ? kernels_.count_within
                          : both_ ? kernels_.count
                                  : kernels_.count_asked;
    kernels[weighted_](one, two, limits_, sums, unsure);
  }

  static CrowdNode crowd_node(const Crowds& crowds, const Weights& weights, std::size_t node) {
    const CrowdTree& tree = crowds.tree;
    const std::size_t first = tree.first_slot(0, node);
    return {{tree.positions(0) + first, tree.positions(1) + first, tree.positions(2) + first},
            tree.leaf_boxes(node).low[0],
            tree.leaf_boxes(node).high[0],
            crowds.weights == nullptr ? nullptr : crowds.weights + first,
            weights.of_leaves(node),
            static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(tree.end_slot(0, node) - first)};
  }

  static void decide(void* context, std::uint32_t i, std::uint32_t j, bool both) {
    auto& self = *static_cast<Counter*>(context);
    if (!self.may_decide()) return;
    if (!self.question_.closer(self.asked_.point(i), self.others_.point(j))) return;
    self.tally_.of_slots[i] += weight(self.question_.others, j);
    if (both) self.tally_.of_slots[j] += weight(self.question_.asked, i);
  }

  // Two nodes are compared by floats in the time that so many decisions take, or more.
  static constexpr std::uint64_t kDecisionsANode = 8;

  const CrowdQuery& question_;
  const CrowdTree& asked_;
  const CrowdTree& others_;
  bool both_;
  const Weights& asked_weights_;
  const Weights& other_weights_;
  core::BoxTest boxes_;
  std::uint64_t decisions_left_;
  bool gave_up_ = decisions_left_ == 0;
  Limits limits_;
  const CrowdKernels& kernels_;
  unsigned weighted_;
  Tally& tally_;
  Numbers of_slot_lanes_;  // of the query node
  Numbers of_leaf_lanes_;
  std::size_t node_ = 0;
};

using Tallies = core::Vector<std::optional<Tally>>;

void write_counts(const CrowdTree& tree, const Tallies& tallies, const core::Resources& with,
                  std::uint32_t* counts) {
  with.crew.split(tree.nodes(0), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t node = begin; node < end; ++node) {
      std::uint32_t sums[kNodePoints] = {};
      const std::size_t first = tree.first_slot(0, node);
      const std::size_t size = tree.end_slot(0, node) - first;
      for (const std::optional<Tally>& tally : tallies) {
        if (!tally) continue;
        std::uint32_t of_all = 0;
        for (unsigned level = 0; level <= tree.top(); ++level) {
          of_all += tally->of_nodes[tree.number(level, node >> (4 * level))];
        }
        for (std::size_t i = 0; i < size; ++i) {
          const std::size_t slot = first + i;
          sums[i] += of_all + tally->of_leaves[slot / kCrowdLanes] + tally->of_slots[slot];
        }
      }
      for (std::size_t i = 0; i < size; ++i) counts[tree.index(first + i)] = sums[i];
    }
  });
}

}  // namespace

bool count_crowds(const CrowdQuery& question, const core::Resources& with, std::uint32_t* counts) {
  const CrowdTree& asked = question.asked.tree;
  const bool both = &asked == &question.others.tree;
  const Weights asked_weights(question.asked, with.memory);
  std::optional<Weights> others;
  if (!both) others.emplace(question.others, with.memory);
  const Weights& other_weights = both ? asked_weights : *others;

  // Of two sets, every entry is one worker's alone.
  Tallies tallies(both ? with.crew.size() : 1, &with.memory);
  if (!both) tallies[0].emplace(asked, with.memory);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> gave_up{false};
  with.crew.run([&](unsigned worker) {
    std::optional<Tally>& tally = tallies[both ? worker : 0];
    if (next >= asked.nodes(0)) return;
    if (!tally) tally.emplace(asked, with.memory);
    Counter counter(question, asked_weights, other_weights, *tally, with.memory);
    for (std::size_t node = next++; node < asked.nodes(0) && !core::is_stopping() && !gave_up;
         node = next++) {
      counter.count(node);
      if (counter.gave_up()) gave_up = true;
    }
  });
  if (gave_up) return false;
  write_counts(asked, tallies, with, counts);
  return true;
}

}  // namespace beespace::cpu
