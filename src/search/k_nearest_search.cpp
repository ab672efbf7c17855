#include "search/k_nearest_search.hpp"

#include "base/dynamic_schedule.hpp"
#include "base/resize_for.hpp"
#include "base/stopping.hpp"
#include "exact/exact_distance.hpp"
#include "kernels/tree_walk.hpp"
#include "tree/point_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <span>

namespace beespace::search {

namespace {

constexpr std::size_t kLeafPoints = core::kFanOut;

constexpr std::size_t kLeavesAtOnce = 32;  // neighbours that one worker looks up

// More than are wanted, that floats may leave open.
constexpr std::size_t kMoreThanWanted = 24;

constexpr std::size_t kMostPrefetched = 16;  // entries of a row

// Takes a point out of the row of the nearest ones. One that is not among them has so many others
// at its position that all of them are, with lower ids: then the last one is too many.
void leave_out(PointId self, const Nearest* found, std::size_t count, Nearest* row) {
  std::size_t at = 0;
  while (at + 1 < count && found[at].id != self) ++at;
  std::copy_n(found, at, row);
  std::copy(found + at + 1, found + count, row + at);
}

// The rows of one worker, leaf by leaf of the tree.
class LeafRows {
 public:
  LeafRows(const core::PointTree& tree, const cpu::TreeWalks& walks, core::NearestList& list,
           core::Vector<Nearest>& found, core::Vector<std::uint32_t>& slots, NearestRows& rows)
      : tree_(tree),
        walks_(walks),
        list_(list),
        found_(found),
        slots_(slots),
        rows_(rows),
        wanted_(rows.length) {}

  // Memory for a worker, at once, as it depends on the schedule which of them will need it.
  static void make_room(std::size_t wanted, core::Vector<Nearest>& found,
                        core::Vector<std::uint32_t>& slots) {
    found.resize(wanted + 1);
    if (wanted <= cpu::LeafNeighbors::kMostWanted) slots.resize(kLeafPoints * room(wanted));
  }

  void write(std::size_t leaf) {
    const std::size_t first = leaf * kLeafPoints;
    const std::size_t end = std::min(first + kLeafPoints, tree_.size());
    for (std::size_t slot = first; slot < end; ++slot) {  // rows lie anywhere, as ids do
      prefetch(row_of(static_cast<std::uint32_t>(slot)));
    }
    cpu::LeafNeighbors near{slots_.data(), room(wanted_), {}};
    if (wanted_ <= cpu::LeafNeighbors::kMostWanted) {
      walks_.find_nearest_of_leaf(tree_.view(), leaf, wanted_, near);
    }
    double reach_m = std::numeric_limits<double>::infinity();
    for (std::size_t slot = first; slot < end; ++slot) {
      const auto self = static_cast<std::uint32_t>(slot);
      const std::size_t place = slot - first;
      // As many as are around the point before, are no farther from here than from
      // there and the way between the two. Distances and sums are off by a few 2^-53.
      if (slot > first) reach_m += distance(tree_.point(self), tree_.point(self - 1));
      Nearest* const row = row_of(self);
      const std::span<const std::uint32_t> candidates(near.slots + place * near.room,
                                                      near.counts[place]);
      if (candidates.empty()) {
        search(self, wanted_ == 1 ? reach_in_leaf(self, first, end) : reach_m, row);
      } else if (!write_sorted(self, candidates, row)) {
        decide(self, candidates, row);
      }
      reach_m = row[wanted_ - 1].distance_m;
    }
  }

 private:
  static std::size_t room(std::size_t wanted) { return wanted + kMoreThanWanted; }

  [[nodiscard]] Nearest* row_of(std::uint32_t self) const {
    return rows_.entries.data() + std::size_t{tree_.id(self)} * wanted_;
  }

  void prefetch(const Nearest* row) const {
    constexpr std::size_t kEntriesALine = 64 / sizeof(Nearest);
    for (std::size_t i = 0; i < std::min(wanted_, kMostPrefetched); i += kEntriesALine) {
      __builtin_prefetch(row + i, 1);
    }
  }

  // Writes the row if doubles leave no doubt about its order, and whether they do.
  bool write_sorted(std::uint32_t self, std::span<const std::uint32_t> slots, Nearest* row) const {
    const Point& place = tree_.point(self);
    double last = 0.0;
    bool is_clear = true;
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const double squared = core::squared_distance(tree_.point(slots[i]), place);
      is_clear &= i == 0 || core::is_surely_nearer(last, squared);
      if (i >= wanted_) continue;
      last = squared;
      row[i] = {tree_.id(slots[i]), std::sqrt(squared)};
    }
    return is_clear;
  }

  // Exactly, of these.
  void decide(std::uint32_t self, std::span<const std::uint32_t> slots, Nearest* row) {
    const Point& place = tree_.point(self);
    list_.start(place, wanted_, std::numeric_limits<double>::infinity());
    for (const std::uint32_t slot : slots) {
      const Point& point = tree_.point(slot);
      list_.offer(point, tree_.id(slot), core::squared_distance(point, place));
    }
    list_.write(row);
  }

  // A distance within which the point has another one.
  [[nodiscard]] double reach_in_leaf(std::uint32_t self, std::size_t first, std::size_t end) const {
    double squared = std::numeric_limits<double>::infinity();
    for (std::size_t slot = first; slot < end; ++slot) {
      if (slot == self) continue;
      const Point& other = tree_.point(static_cast<std::uint32_t>(slot));
      squared = std::min(squared, core::squared_distance(tree_.point(self), other));
    }
    return std::sqrt(squared);
  }

  // Exactly, whatever is around.
  void search(std::uint32_t self, double reach_m, Nearest* row) {
    const Point& place = tree_.point(self);
    list_.start(place, wanted_ + 1, reach_m * (1.0 + 0x1p-48));  // the point itself is found, too
    walks_.find_nearest(tree_.view(), place, list_);
    list_.write(found_.data());
    leave_out(tree_.id(self), found_.data(), wanted_ + 1, row);
  }

  const core::PointTree& tree_;
  const cpu::TreeWalks& walks_;
  core::NearestList& list_;
  core::Vector<Nearest>& found_;
  core::Vector<std::uint32_t>& slots_;
  NearestRows& rows_;
  std::size_t wanted_;
};

}  // namespace

void find_k_nearest(const PointsView& points, const core::Bounds& bounds, std::size_t k,
                    const core::Resources& with, const TuningOverrides& tuning,
                    std::span<core::NearestList> lists, NearestRows& rows) {
  const std::size_t size = points.size();
  rows.length = size == 0 ? 0 : std::min(k, size - 1);
  if (rows.length == 0) return rows.entries.clear();
  if (size > rows.entries.max_size() / rows.length) throw std::bad_alloc();
  core::resize_for(rows.entries, size * rows.length, with.crew);
  core::PerWorker<Nearest> found(with);
  core::PerWorker<std::uint32_t> slots(with);
  for (unsigned worker = 0; worker < with.crew.size(); ++worker) {
    LeafRows::make_room(rows.length, found[worker], slots[worker]);
    lists[worker].reserve(rows.length + 1);
  }
  const core::PointTree tree(points, bounds, with);
  const cpu::TreeWalks walks = cpu::tree_walks(tuning.instruction_set);
  const std::size_t leaves = (size + kLeafPoints - 1) / kLeafPoints;
  cpu::schedule(with.crew, leaves, kLeavesAtOnce,
                [&](std::size_t begin, std::size_t end, unsigned worker) {
                  LeafRows work(tree, walks, lists[worker], found[worker], slots[worker], rows);
                  for (std::size_t leaf = begin; leaf < end && !core::is_stopping(); ++leaf) {
                    work.write(leaf);
                  }
                });
}

}  // namespace beespace::search
