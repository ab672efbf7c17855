// Disjoint sets: groups of elements, joined pair by pair in any order on any thread.
//
// A forest in one array: every element points to one with a lower or the same number, the root of
// its set to itself. Links are made by compare-and-swap from higher to lower roots, so the sets,
// though not the trees, are the same for every order (Anderson and Woll, 1991).
#pragma once

#include "base/buffer.hpp"
#include "base/resources.hpp"

#include <atomic>
#include <cstdint>
#include <utility>

namespace beespace::core {

class DisjointSets {
 public:
  DisjointSets(Memory& memory, std::uint32_t size) : parent_(memory, size) {
    for (std::uint32_t i = 0; i < size; ++i) parent_[i] = i;
  }

  // The root: the lowest element of its set once no more are joined. Halves the path to it.
  std::uint32_t root(std::uint32_t thing) {
    for (;;) {
      const std::uint32_t parent = load(thing);
      if (parent == thing) return thing;
      const std::uint32_t grandparent = load(parent);
      if (grandparent == parent) return parent;
      // Another thread may have written a still lower ancestor in between: then that one stays.
      std::uint32_t expected = parent;
      at(thing).compare_exchange_weak(expected, grandparent, std::memory_order_relaxed);
      thing = grandparent;
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    for (;;) {
      a = root(a);
      b = root(b);
      if (a == b) return;
      if (a < b) std::swap(a, b);
      std::uint32_t expected = a;
      if (at(a).compare_exchange_strong(expected, b, std::memory_order_relaxed)) return;
    }
  }

 private:
  std::atomic_ref<std::uint32_t> at(std::uint32_t thing) {
    return std::atomic_ref<std::uint32_t>(parent_[thing]);
  }
  std::uint32_t load(std::uint32_t thing) { return at(thing).load(std::memory_order_relaxed); }

  Buffer<std::uint32_t> parent_;
};

}  // namespace beespace::core
