// The uses of places that are in each other's cylinders: the tasks of cylinders/cylinder_join.hpp,
// and of cylinders/cylinder_rows.hpp.
#pragma once

#include "base/disjoint_sets.hpp"
#include "base/resources.hpp"
#include "cylinders/cylinder_join.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace beespace::search {

// Flags, one byte each; any worker may set them.
class Flags {
 public:
  Flags(core::Memory& memory, std::size_t size) : flags_(memory, size) {
    std::fill_n(flags_.data(), size, std::uint8_t{0});
  }
  [[nodiscard]] bool operator[](std::size_t i) {
    return std::atomic_ref<std::uint8_t>(flags_[i]).load(std::memory_order_relaxed) != 0;
  }
  void set(std::size_t i) {
    std::atomic_ref<std::uint8_t>(flags_[i]).store(1, std::memory_order_relaxed);
  }

 private:
  core::Buffer<std::uint8_t> flags_;
};

// Adds to a count that other workers may add to.
inline void add_shared(std::uint32_t& count, std::uint32_t more, bool one_worker) {
  if (one_worker) {
    count += more;
  } else {
    std::atomic_ref<std::uint32_t>(count).fetch_add(more, std::memory_order_relaxed);
  }
}

// Calls near(i, j) for the slots of rows: a task of cylinders/cylinder_rows.hpp.
template <class Near>
struct EachNear {
  const Near& near;

  static bool enough() { return false; }
};

// Calls visit(node) for a node and all below it.
template <class Visit>
void for_each_below(const core::CylinderTree& tree, core::CylinderNode top, const Visit& visit) {
  std::size_t first = top.node;
  std::size_t end = top.node + 1;
  for (unsigned level = top.level;; --level) {
    for (std::size_t node = first; node < end; ++node) visit(core::CylinderNode{level, node});
    if (level == 0) return;
    end = tree.end_child(level, end - 1);
    first = tree.first_child(first);
  }
}

// Calls settle(node) for all nodes but leaves, children before parents.
template <class Settle>
void for_each_upward(const core::CylinderTree& tree, const Settle& settle) {
  for (unsigned level = 1; level <= tree.top(); ++level) {
    for (std::size_t node = 0; node < tree.nodes(level); ++node) {
      settle(core::CylinderNode{level, node});
    }
  }
}

// Marks the places that are near another one. Nodes whose places are all marked need no more work.
class Marks {
 public:
  // Of two trees, those of the first are marked.
  Marks(const core::CylinderTree& tree, bool two_trees, core::Memory& memory)
      : tree_(tree),
        two_trees_(two_trees),
        marked_(memory, tree.size()),
        all_(memory, tree.node_count()) {}

  [[nodiscard]] bool operator[](std::size_t slot) { return marked_[slot]; }

  bool settled(core::CylinderNode a, core::CylinderNode b) {
    return all_[number(a)] && (two_trees_ || all_[number(b)]);
  }
  void near_itself(core::CylinderNode a) { mark(a); }
  void near(core::CylinderNode a, core::CylinderNode b) {
    mark(a);
    if (!two_trees_) mark(b);
  }
  void near(std::size_t i, std::size_t j) {
    marked_.set(i);
    if (!two_trees_) marked_.set(j);
  }
  void looked_into(core::CylinderNode leaf) {
    const std::size_t end = tree_.end_slot(0, leaf.node);
    for (std::size_t slot = tree_.first_slot(0, leaf.node); slot < end; ++slot) {
      if (!marked_[slot]) return;
    }
    all_.set(number(leaf));
  }
  void settle_upward() {
    for_each_upward(tree_, [&](core::CylinderNode node) {
      const std::size_t end = tree_.end_child(node.level, node.node);
      for (std::size_t child = tree_.first_child(node.node); child < end; ++child) {
        if (!all_[tree_.number(node.level - 1, child)]) return;
      }
      all_.set(number(node));
    });
  }

 private:
  [[nodiscard]] std::size_t number(core::CylinderNode node) const {
    return tree_.number(node.level, node.node);
  }
  void mark(core::CylinderNode node) {
    if (all_[number(node)]) return;
    for_each_below(tree_, node, [&](core::CylinderNode below) { all_.set(number(below)); });
    const std::size_t end = tree_.end_slot(node.level, node.node);
    for (std::size_t slot = tree_.first_slot(node.level, node.node); slot < end; ++slot) {
      marked_.set(slot);
    }
  }

  const core::CylinderTree& tree_;
  bool two_trees_;
  Flags marked_;
  Flags all_;
};

// Counts the near places of each. Places near all of a node are counted once, and added up in the
// end.
class Counts {
 public:
  Counts(const core::CylinderTree& first, const core::CylinderTree& second, bool one_worker,
         core::Memory& memory)
      : first_(first),
        second_(second),
        two_trees_(&first != &second),
        one_worker_(one_worker),
        of_slots_(memory, first.size()),
        of_nodes_(memory, first.node_count()) {
    std::fill_n(of_slots_.data(), first.size(), 0U);
    std::fill_n(of_nodes_.data(), first.node_count(), 0U);
  }

  static bool settled(core::CylinderNode, core::CylinderNode) { return false; }
  void near_itself(core::CylinderNode a) {
    add(of_nodes_[first_.number(a.level, a.node)], first_.count(a.level, a.node) - 1);
  }
  void near(core::CylinderNode a, core::CylinderNode b) {
    add(of_nodes_[first_.number(a.level, a.node)], second_.count(b.level, b.node));
    if (two_trees_) return;
    add(of_nodes_[first_.number(b.level, b.node)], first_.count(a.level, a.node));
  }
  void near(std::size_t i, std::size_t j) {
    add(of_slots_[i], 1);
    if (!two_trees_) add(of_slots_[j], 1);
  }
  static void looked_into(core::CylinderNode) {}

  // After that the counts of slots are complete.
  void add_up() {
    for (unsigned level = first_.top(); level > 0; --level) {
      for (std::size_t node = 0; node < first_.nodes(level); ++node) {
        const std::uint32_t more = of_nodes_[first_.number(level, node)];
        const std::size_t end = first_.end_child(level, node);
        for (std::size_t child = first_.first_child(node); child < end; ++child) {
          of_nodes_[first_.number(level - 1, child)] += more;
        }
      }
    }
    for (std::size_t slot = 0; slot < first_.size(); ++slot) {
      of_slots_[slot] += of_nodes_[slot / core::CylinderTree::kFanOut];
    }
  }
  [[nodiscard]] std::uint32_t operator[](std::size_t slot) const { return of_slots_[slot]; }

 private:
  void add(std::uint32_t& count, std::size_t more) const {
    add_shared(count, static_cast<std::uint32_t>(more), one_worker_);
  }

  const core::CylinderTree& first_;
  const core::CylinderTree& second_;
  bool two_trees_;
  bool one_worker_;
  core::Buffer<std::uint32_t> of_slots_;
  core::Buffer<std::uint32_t> of_nodes_;
};

// The groups. Nodes that are known to be of one group each are looked into until they are known to
// be of the same.
class Groups {
 public:
  Groups(const core::CylinderTree& tree, core::Memory& memory)
      : tree_(tree),
        sets_(memory, static_cast<std::uint32_t>(tree.size())),
        one_(memory, tree.node_count()) {}

  [[nodiscard]] std::uint32_t root(std::size_t slot) {
    return sets_.root(static_cast<std::uint32_t>(slot));
  }

  bool settled(core::CylinderNode a, core::CylinderNode b) {
    return one_[number(a)] && one_[number(b)] && root(first(a)) == root(first(b));
  }
  void near_itself(core::CylinderNode a) { unite(a); }
  void near(core::CylinderNode a, core::CylinderNode b) {
    unite(a);
    unite(b);
    near(first(a), first(b));
  }
  void near(std::size_t i, std::size_t j) {
    sets_.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
  }
  void looked_into(core::CylinderNode leaf) {
    if (one_[number(leaf)]) return;
    const std::uint32_t one = root(first(leaf));
    const std::size_t end = tree_.end_slot(0, leaf.node);
    for (std::size_t slot = first(leaf) + 1; slot < end; ++slot) {
      if (root(slot) != one) return;
    }
    one_.set(number(leaf));
  }
  void settle_upward() {
    for_each_upward(tree_, [&](core::CylinderNode node) {
      const std::size_t end = tree_.end_child(node.level, node.node);
      for (std::size_t child = tree_.first_child(node.node); child < end; ++child) {
        if (!one_[tree_.number(node.level - 1, child)]) return;
        if (root(first({node.level - 1, child})) != root(first(node))) return;
      }
      one_.set(number(node));
    });
  }

 private:
  [[nodiscard]] std::size_t number(core::CylinderNode node) const {
    return tree_.number(node.level, node.node);
  }
  [[nodiscard]] std::size_t first(core::CylinderNode node) const {
    return tree_.first_slot(node.level, node.node);
  }
  void unite(core::CylinderNode node) {
    if (one_[number(node)]) return;
    const std::size_t end = tree_.end_slot(node.level, node.node);
    for (std::size_t slot = first(node) + 1; slot < end; ++slot) near(first(node), slot);
    // Only now: another worker that sees a flag relies on it.
    for_each_below(tree_, node, [&](core::CylinderNode below) { one_.set(number(below)); });
  }

  const core::CylinderTree& tree_;
  core::DisjointSets sets_;
  Flags one_;
};

}  // namespace beespace::search
