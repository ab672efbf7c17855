// Pairs of places that are in each other's cylinders, kept or shown.
#pragma once

#include "base/pair_order.hpp"
#include "base/stopping.hpp"
#include "cylinders/cylinder_join.hpp"
#include "cylinders/cylinder_rows.hpp"

#include <beespace/pairs.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <utility>

namespace beespace::search {

// How many pairs all workers may keep.
struct PairsKept {
  std::uint64_t most;
  std::atomic<std::uint64_t> total = 0;  // in full chunks

  [[nodiscard]] bool enough() const {
    return total.load(std::memory_order_relaxed) > most || core::is_stopping();
  }
};

// Keeps the pairs of one worker, as found; stops soon after there are too many.
class KeepPairs {
 public:
  KeepPairs(PairsKept& all, core::FoundPairs& found) : all_(all), found_(found) {}

  [[nodiscard]] bool enough() const { return all_.enough(); }
  void take(PointId first, PointId second) {
    if (chunk_ == nullptr || chunk_->size == chunk_->capacity) {
      if (chunk_ != nullptr) all_.total += chunk_->size;
      chunk_ = &found_.open_chunk();
    }
    chunk_->first[chunk_->size] = first;
    chunk_->second[chunk_->size++] = second;
  }

 private:
  PairsKept& all_;
  core::FoundPairs& found_;
  core::FoundPairs::Chunk* chunk_ = nullptr;
};

// The visitor that all workers show pairs to, one at a time.
struct Audience {
  const PairVisitor& visit;
  std::mutex mutex = {};
  std::atomic<bool> gone = false;
};

// Shows the pairs of one worker in batches, lower id first.
class ShowPairs {
 public:
  explicit ShowPairs(Audience& audience) : audience_(audience) {}
  ShowPairs(const ShowPairs&) = delete;
  ShowPairs& operator=(const ShowPairs&) = delete;
  ~ShowPairs() { show(); }

  [[nodiscard]] bool enough() const { return audience_.gone.load(std::memory_order_relaxed); }
  void take(PointId first, PointId second) {
    if (size_ == batch_.size()) show();
    if (second < first) std::swap(first, second);
    batch_[size_++] = {first, second};
  }

 private:
  void show() {
    const std::span<const Pair> pairs(batch_.data(), std::exchange(size_, 0));
    if (pairs.empty()) return;
    const std::lock_guard lock(audience_.mutex);
    if (!audience_.gone && !audience_.visit(pairs)) audience_.gone = true;
  }

  Audience& audience_;
  std::array<Pair, kMostPairsAtOnce> batch_;
  std::size_t size_ = 0;
};

// Pairs of slots of rows, for either use.
template <class Sink>
class RowPairs {
 public:
  template <class... Arguments>
  explicit RowPairs(const core::CylinderRows& rows, Arguments&... sink)
      : rows_(rows), sink_(sink...) {}

  [[nodiscard]] bool enough() const { return sink_.enough(); }
  void near(std::size_t i, std::size_t j) { sink_.take(rows_.index(i), rows_.index(j)); }

 private:
  const core::CylinderRows& rows_;
  Sink sink_;
};

// Pairs of slots of trees: a task of cylinders/cylinder_join.hpp. Splits nodes that are near as a
// whole.
template <class Sink>
class TreePairs {
 public:
  template <class... Arguments>
  TreePairs(const core::CylinderTree& first, const core::CylinderTree& second, Arguments&... sink)
      : first_(first), second_(second), sink_(sink...) {}

  [[nodiscard]] bool settled(core::CylinderNode, core::CylinderNode) const {
    return sink_.enough();
  }
  void near_itself(core::CylinderNode a) {
    const std::size_t end = first_.end_slot(a.level, a.node);
    for (std::size_t i = first_.first_slot(a.level, a.node); i < end && !sink_.enough(); ++i) {
      for (std::size_t j = i + 1; j < end; ++j) near(i, j);
    }
  }
  void near(core::CylinderNode a, core::CylinderNode b) {
    const std::size_t end = first_.end_slot(a.level, a.node);
    const std::size_t begin_b = second_.first_slot(b.level, b.node);
    const std::size_t end_b = second_.end_slot(b.level, b.node);
    for (std::size_t i = first_.first_slot(a.level, a.node); i < end && !sink_.enough(); ++i) {
      for (std::size_t j = begin_b; j < end_b; ++j) near(i, j);
    }
  }
  void near(std::size_t i, std::size_t j) { sink_.take(first_.index(i), second_.index(j)); }
  static void looked_into(core::CylinderNode) {}

 private:
  const core::CylinderTree& first_;
  const core::CylinderTree& second_;
  Sink sink_;
};

}  // namespace beespace::search
