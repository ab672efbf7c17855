#include "search/column_answer.hpp"

#include "base/memory.hpp"
#include "base/stopping.hpp"
#include "exact/exact_distance.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::search {

static_assert(sizeof(Pair) == sizeof(std::int64_t) && alignof(Pair) <= alignof(std::int64_t));

namespace {

// So many pairs ahead a point is asked for: enough for what is not in a near cache.
constexpr std::size_t kPairsAhead = 16;

template <class Number>
void advise(Number* column, std::uint64_t size) {
  if (column != nullptr) core::advise_huge_pages(column, size * sizeof(Number));
}

}  // namespace

void PairDistances::prepare(PointId other) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    __builtin_prefetch(static_cast<const std::byte*>(others_.axes()[axis]) +
                       static_cast<std::ptrdiff_t>(other) * others_.stride_bytes()[axis]);
  }
}

void PairDistances::write(double* distances_m, std::size_t i, const Pair& pair,
                          const core::SortedPairs& sorted) const {
  if (distances_m == nullptr) return;
  prepare(core::pair_at(sorted.pairs, std::min(i + kPairsAhead, sorted.end - 1)).second);
  distances_m[i] = core::rounded_distance(points_[pair.first], others_[pair.second]);
}

void PairDistances::write_row(double* distances_m, PointId id, const PointId* row,
                              std::size_t length) const {
  const Point point = points_[id];
  for (std::size_t k = 0; k < length; ++k) {
    prepare(row[std::min(k + kPairsAhead, length - 1)]);
    distances_m[k] = core::rounded_distance(point, others_[row[k]]);
  }
}

void PairColumnsAnswer::open(std::uint64_t size, const core::Resources&) {
  const core::NotStopping scope;
  columns_ = room_(size);
  advise(columns_.first, size);
  advise(columns_.second, size);
  advise(columns_.distances_m, size);
}

void PairColumnsAnswer::take(const core::SortedPairs& sorted) {
  core::in_stretches(sorted.end - sorted.begin, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = sorted.begin + from; i < sorted.begin + to; ++i) {
      const Pair pair = core::pair_at(sorted.pairs, i);
      distances_.write(columns_.distances_m, i, pair, sorted);
      columns_.first[i] = pair.first;
      columns_.second[i] = pair.second;
    }
  });
}

void PairColumnsAnswer::take_row(std::uint64_t begin, PointId id, const PointId* row,
                                 std::size_t length) {
  std::fill_n(columns_.first + begin, length, id);
  std::copy_n(row, length, columns_.second + begin);
  if (columns_.distances_m != nullptr) {
    distances_.write_row(columns_.distances_m + begin, id, row, length);
  }
}

void RowColumnsAnswer::open(std::uint64_t size, const core::Resources&) {
  const core::NotStopping scope;
  columns_ = room_(row_count_, size);
  advise(columns_.offsets, row_count_ + 1);
  advise(columns_.ids, size);
  advise(columns_.distances_m, size);
  if (size == 0) std::fill_n(columns_.offsets, row_count_, 0);
  columns_.offsets[row_count_] = static_cast<std::int64_t>(size);
}

void RowColumnsAnswer::take(const core::SortedPairs& sorted) {
  for_each_row_of(
      sorted,
      [this](std::uint64_t id, std::size_t begin) {
        columns_.offsets[id] = static_cast<std::int64_t>(begin);
      },
      [&](std::size_t i, const Pair& pair) {
        distances_.write(columns_.distances_m, i, pair, sorted);
        columns_.ids[i] = pair.second;
      });
}

void RowColumnsAnswer::take_row(std::uint64_t begin, PointId id, const PointId* row,
                                std::size_t length) {
  columns_.offsets[id] = static_cast<std::int64_t>(begin);
  std::copy_n(row, length, columns_.ids + begin);
  if (columns_.distances_m != nullptr) {
    distances_.write_row(columns_.distances_m + begin, id, row, length);
  }
}

}  // namespace beespace::search
