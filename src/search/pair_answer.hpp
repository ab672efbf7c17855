// Where pairs go, and rows of neighbours: into vectors of the caller, or into columns that the
// caller gives.
#pragma once

#include "base/buffer.hpp"
#include "base/pair_order.hpp"
#include "base/resources.hpp"
#include "base/stopping.hpp"

#include <beespace/id_rows.hpp>
#include <beespace/pairs.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::search {

// Is opened once. Then it takes all pairs, either in buckets that were sorted in its own memory, or
// in rows; several workers at once.
class PairAnswer {
 public:
  PairAnswer() = default;
  PairAnswer(const PairAnswer&) = delete;
  PairAnswer& operator=(const PairAnswer&) = delete;
  virtual ~PairAnswer() = default;

  // Makes room for so many pairs.
  virtual void open(std::uint64_t size, const core::Resources& with) = 0;
  // Where so many pairs can be sorted.
  virtual Pair* place() = 0;
  // Pairs that were sorted there.
  virtual void take(const core::SortedPairs& sorted) = 0;
  // The pairs of one point: those from `begin` on.
  virtual void take_row(std::uint64_t begin, PointId id, const PointId* row,
                        std::size_t length) = 0;
};

class PairVector final : public PairAnswer {
 public:
  explicit PairVector(std::vector<Pair>& pairs) : pairs_(pairs) {}

  void open(std::uint64_t size, const core::Resources& with) override;
  Pair* place() override { return pairs_.data(); }
  void take(const core::SortedPairs&) override {}  // they are there
  void take_row(std::uint64_t begin, PointId id, const PointId* row, std::size_t length) override;

 private:
  std::vector<Pair>& pairs_;
};

// Rows of so many points.
class RowVectors final : public PairAnswer {
 public:
  RowVectors(IdRows& rows, std::size_t row_count) : rows_(rows), row_count_(row_count) {}

  void open(std::uint64_t size, const core::Resources& with) override;
  Pair* place() override;
  void take(const core::SortedPairs& sorted) override;
  void take_row(std::uint64_t begin, PointId id, const PointId* row, std::size_t length) override;

 private:
  IdRows& rows_;
  std::size_t row_count_;
  const core::Resources* with_ = nullptr;
  core::Buffer<Pair> pairs_;
};

// Calls write(i, pair) for these pairs, and begin_row(id, i) for each of their rows before it, with
// the place of the first pair that is not before the row.
template <class BeginRow, class Write>
void for_each_row_of(const core::SortedPairs& sorted, const BeginRow& begin_row,
                     const Write& write) {
  std::uint64_t next = sorted.first_id;
  core::in_stretches(sorted.end - sorted.begin, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = sorted.begin + from; i < sorted.begin + to; ++i) {
      const Pair pair = core::pair_at(sorted.pairs, i);
      for (; next <= pair.first; ++next) begin_row(next, i);
      write(i, pair);
    }
  });
  for (; next < sorted.end_id; ++next) begin_row(next, sorted.end);
}

}  // namespace beespace::search
