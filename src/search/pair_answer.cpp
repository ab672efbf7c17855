#include "search/pair_answer.hpp"

#include "base/answered.hpp"
#include "base/resize_for.hpp"

#include <algorithm>

namespace beespace::search {

void PairVector::open(std::uint64_t size, const core::Resources& with) {
  core::resize_for(pairs_, size, with.crew);
}

void PairVector::take_row(std::uint64_t begin, PointId id, const PointId* row, std::size_t length) {
  Pair* const to = pairs_.data() + begin;
  for (std::size_t k = 0; k < length; ++k) to[k] = {id, row[k]};
}

void RowVectors::open(std::uint64_t size, const core::Resources& with) {
  with_ = &with;
  if (row_count_ == 0) return core::empty(rows_);
  core::resize_for(rows_.offsets, row_count_ + 1, with.crew);
  if (size == 0) std::fill(rows_.offsets.begin(), rows_.offsets.end(), std::uint64_t{0});
  rows_.offsets[row_count_] = size;
  core::resize_for(rows_.ids, size, with.crew);
}

Pair* RowVectors::place() {
  pairs_ = core::Buffer<Pair>(with_->memory, rows_.ids.size());
  return pairs_.data();
}

void RowVectors::take(const core::SortedPairs& sorted) {
  for_each_row_of(
      sorted, [this](std::uint64_t id, std::size_t begin) { rows_.offsets[id] = begin; },
      [this](std::size_t i, const Pair& pair) { rows_.ids[i] = pair.second; });
}

void RowVectors::take_row(std::uint64_t begin, PointId id, const PointId* row, std::size_t length) {
  rows_.offsets[id] = begin;
  std::copy_n(row, length, rows_.ids.data() + begin);
}

}  // namespace beespace::search
