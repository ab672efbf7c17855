#include "tree/crowd_groups.hpp"
#include "base/stopping.hpp"

#include "grid/near_pairs.hpp"
#include "tree/box_test.hpp"

#include <atomic>

namespace beespace::core {

namespace {

// A node of a tree, and whether all of its points are known to be of one set.
struct Crowd {
  unsigned level;
  std::size_t node;
  bool united;
};

// The same for a leaf, which is lane `lane` of its node.
struct Leaf {
  const LeafBoxes* boxes;
  std::size_t lane;
  std::uint32_t begin;
  std::uint32_t end;
  bool united;
};

class Joiner {
 public:
  Joiner(const CrowdTree& tree, double threshold, double units_per_m, const ProximityTest& closer,
         std::uint64_t most_decisions, DisjointSets& sets, Memory& memory)
      : tree_(tree),
        boxes_(threshold, closer),
        limits_(threshold, units_per_m),
        closer_(closer),
        sets_(sets),
        united_(memory, tree.leaves() + tree.node_count()),
        most_decisions_(most_decisions) {
    std::fill_n(united_.data(), tree.leaves() + tree.node_count(), std::uint8_t{0});
  }

  // Whether floats left more open than may be decided one by one; then not all is joined.
  [[nodiscard]] bool gave_up() const {
    return decisions_.load(std::memory_order_relaxed) >= most_decisions_;
  }

  // Joins what is near within a node.
  void join_within(unsigned level, std::size_t node) {
    if (boxes_(tree_.box(level, node), tree_.box(level, node)) == Reach::kNear) {
      join_all(level, node);
    } else if (level == 0) {
      join_leaves_within(node);
    } else {
      const std::size_t first = tree_.first_child(node);
      const std::size_t end = tree_.end_child(level, node);
      bool united = true;
      for (std::size_t i = first; i < end; ++i) {
        join_within(level - 1, i);
        for (std::size_t k = first; k < i; ++k) {
          join_between(crowd(level - 1, k, false), crowd(level - 1, i, false));
        }
      }
      for (std::size_t i = first; united && i < end; ++i) {
        const Crowd child = crowd(level - 1, i, false);
        united = child.united && same_set(crowd(level - 1, first, false), child);
      }
      if (united) set_united(node_flag(level, node));
    }
  }

  void join_between(const Crowd& a, const Crowd& b) {
    if (gave_up()) return;
    if (a.united && b.united && same_set(a, b)) return;
    switch (boxes_(tree_.box(a.level, a.node), tree_.box(b.level, b.node))) {
      case Reach::kFar:
        return;
      case Reach::kNear:
        sets_.join(first(a), first(b));
        if (!a.united) join_all(a.level, a.node);
        if (!b.united) join_all(b.level, b.node);
        return;
      case Reach::kOpen:
        break;
    }
    if (a.level == 0 && b.level == 0) return join_leaves_between(a, b);
    const bool split_a = a.level > b.level;
    const Crowd& whole = split_a ? a : b;
    const Crowd& other = split_a ? b : a;
    const std::size_t end = tree_.end_child(whole.level, whole.node);
    for (std::size_t i = tree_.first_child(whole.node); i < end; ++i) {
      join_between(crowd(whole.level - 1, i, whole.united), other);
    }
  }

  [[nodiscard]] Crowd crowd(unsigned level, std::size_t node, bool united) {
    return {level, node, united || is_united(node_flag(level, node))};
  }

 private:
  // What is noted is true of the sets when all work is done, so no worker waits for another's note.
  [[nodiscard]] bool is_united(std::size_t flag) {
    return std::atomic_ref<std::uint8_t>(united_[flag]).load(std::memory_order_relaxed) != 0;
  }
  void set_united(std::size_t flag) {
    std::atomic_ref<std::uint8_t>(united_[flag]).store(1, std::memory_order_relaxed);
  }
  [[nodiscard]] std::size_t node_flag(unsigned level, std::size_t node) const {
    return tree_.leaves() + tree_.number(level, node);
  }

  [[nodiscard]] std::uint32_t first(const Crowd& crowd) const {
    return static_cast<std::uint32_t>(tree_.first_slot(crowd.level, crowd.node));
  }
  [[nodiscard]] bool same_set(const Crowd& a, const Crowd& b) {
    return sets_.root(first(a)) == sets_.root(first(b));
  }

  void join_range(std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin + 1; slot < end; ++slot) {
      sets_.join(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(slot));
    }
  }
  void join_all(unsigned level, std::size_t node) {
    join_range(tree_.first_slot(level, node), tree_.end_slot(level, node));
    set_united(node_flag(level, node));
  }

  [[nodiscard]] Leaf leaf(std::size_t node, std::size_t lane, bool united) {
    const std::size_t begin = tree_.first_slot(0, node) + lane * kLeafPoints;
    const std::size_t end = std::min(begin + kLeafPoints, tree_.size());
    return {&tree_.leaf_boxes(node), lane, static_cast<std::uint32_t>(begin),
            static_cast<std::uint32_t>(end), united || is_united(begin / kLeafPoints)};
  }

  void join_leaves_within(std::size_t node) {
    for (std::size_t lane = 0; lane < tree_.leaves(node); ++lane) {
      join_within_leaf(leaf(node, lane, false));
      for (std::size_t before = 0; before < lane; ++before) {
        join_between_leaves(leaf(node, before, false), leaf(node, lane, false));
      }
    }
    const Leaf first = leaf(node, 0, false);
    bool united = true;
    for (std::size_t lane = 0; united && lane < tree_.leaves(node); ++lane) {
      const Leaf own = leaf(node, lane, false);
      united = own.united && sets_.root(own.begin) == sets_.root(first.begin);
    }
    if (united) set_united(node_flag(0, node));
  }

  void join_leaves_between(const Crowd& a, const Crowd& b) {
    for (std::size_t k = 0; k < tree_.leaves(a.node); ++k) {
      const Leaf one = leaf(a.node, k, a.united);
      for (std::size_t l = 0; l < tree_.leaves(b.node); ++l) {
        join_between_leaves(one, leaf(b.node, l, b.united));
      }
      if (a.united && b.united && same_set(a, b)) return;
    }
  }

  void join_within_leaf(const Leaf& own) {
    bool united = true;
    if (reach(own, own) == Reach::kNear) {
      join_range(own.begin, own.end);
    } else {
      for (std::uint32_t i = own.begin + 1; i < own.end; ++i) {
        for (std::uint32_t j = own.begin; j < i; ++j) join_if_near(i, j);
      }
      for (std::uint32_t i = own.begin + 1; united && i < own.end; ++i) {
        united = sets_.root(i) == sets_.root(own.begin);
      }
    }
    if (united) set_united(own.begin / kLeafPoints);
  }

  void join_between_leaves(const Leaf& a, const Leaf& b) {
    const Reach all = reach(a, b);
    if (all == Reach::kFar) return;
    const bool one_pair_will_do = a.united && b.united;
    if (one_pair_will_do && sets_.root(a.begin) == sets_.root(b.begin)) return;
    if (all == Reach::kNear) {
      sets_.join(a.begin, b.begin);
      if (!a.united) join_range(a.begin, a.end);
      if (!b.united) join_range(b.begin, b.end);
      return;
    }
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
      const Reach of_point = reach(i, b);
      if (of_point == Reach::kFar) continue;
      if (of_point == Reach::kNear) {
        sets_.join(i, b.begin);
        if (!b.united) join_range(b.begin, b.end);
        if (one_pair_will_do) return;
        continue;
      }
      for (std::uint32_t j = b.begin; j < b.end; ++j) {
        if (join_if_near(i, j) && one_pair_will_do) return;
      }
    }
  }

  // The same for leaves, by positions: floats of boxes are the extremes of the floats of points.
  [[nodiscard]] Reach reach(const Leaf& a, const Leaf& b) const {
    float nearest = 0.0F;
    float farthest = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t up = b.boxes->high[axis][b.lane] - a.boxes->low[axis][a.lane];
      const std::int32_t down = a.boxes->high[axis][a.lane] - b.boxes->low[axis][b.lane];
      const auto most = static_cast<float>(std::max(up, down));
      const auto least = static_cast<float>(std::max(0, -std::min(up, down)));
      farthest += most * most;
      nearest += least * least;
    }
    if (nearest > limits_.surely_far) return Reach::kFar;
    return farthest < limits_.surely_near ? Reach::kNear : Reach::kOpen;
  }

  // Of a point and a leaf.
  [[nodiscard]] Reach reach(std::uint32_t i, const Leaf& from) const {
    float nearest = 0.0F;
    float farthest = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t at = tree_.positions(axis)[i];
      const std::int32_t up = from.boxes->high[axis][from.lane] - at;
      const std::int32_t down = at - from.boxes->low[axis][from.lane];
      const auto most = static_cast<float>(std::max(up, down));
      const auto least = static_cast<float>(std::max(0, -std::min(up, down)));
      farthest += most * most;
      nearest += least * least;
    }
    if (nearest > limits_.surely_far) return Reach::kFar;
    return farthest < limits_.surely_near ? Reach::kNear : Reach::kOpen;
  }

  // Whether they are near and of one set now; what is of one set already is not looked at further.
  bool join_if_near(std::uint32_t i, std::uint32_t j) {
    float squared = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto step = static_cast<float>(tree_.positions(axis)[i] - tree_.positions(axis)[j]);
      squared += step * step;
    }
    if (squared > limits_.surely_far) return false;
    if (squared >= limits_.surely_near) {
      if (sets_.root(i) == sets_.root(j)) return false;
      if (gave_up()) return false;
      decisions_.fetch_add(1, std::memory_order_relaxed);
      if (!closer_(tree_.point(i), tree_.point(j))) return false;
    }
    sets_.join(i, j);
    return true;
  }

  const CrowdTree& tree_;
  BoxTest boxes_;
  SquaredLimits limits_;
  const ProximityTest& closer_;
  DisjointSets& sets_;
  Buffer<std::uint8_t> united_;  // by leaf, then by node
  std::uint64_t most_decisions_;
  std::atomic<std::uint64_t> decisions_{0};
};

// Calls visit(node) for the nodes of `level`, each once, whichever worker comes first.
template <class Visit>
void share_nodes(const CrowdTree& tree, unsigned level, const Resources& with, Visit&& visit) {
  std::atomic<std::size_t> next{0};
  with.crew.run([&](unsigned) {
    for (std::size_t node = next++; node < tree.nodes(level) && !is_stopping(); node = next++) {
      visit(node);
    }
  });
}

}  // namespace

bool join_crowds(const CrowdTree& tree, double threshold, double units_per_m,
                 const ProximityTest& closer, std::uint64_t decisions_a_point,
                 const Resources& with, DisjointSets& sets) {
  Joiner joiner(tree, threshold, units_per_m, closer, decisions_a_point * tree.size(), sets,
                with.memory);
  unsigned level = tree.top();
  // Shared are the nodes of the first level that has enough of them for all workers.
  const std::size_t enough = with.crew.size() == 1 ? 1 : 8 * with.crew.size();
  while (level > 0 && tree.nodes(level) < enough) --level;
  share_nodes(tree, level, with, [&](std::size_t node) { joiner.join_within(level, node); });
  share_nodes(tree, level, with, [&](std::size_t node) {
    for (std::size_t other = node + 1; other < tree.nodes(level); ++other) {
      joiner.join_between(joiner.crowd(level, node, false), joiner.crowd(level, other, false));
    }
  });
  return !joiner.gave_up();
}

}  // namespace beespace::core
