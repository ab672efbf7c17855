// Pairs and rows of neighbours in columns of 64-bit numbers.
//
// A column of ids has 8 bytes a pair, as a pair of PointIds has: pairs are sorted in the column
// itself, and each bucket is widened as soon as it is in order, while it is in the nearest cache.
#pragma once

#include "search/pair_answer.hpp"

#include <beespace/columns.hpp>
#include <beespace/points_view.hpp>

namespace beespace::search {

// The distances of pairs, whose points are asked for some pairs ahead: ids in ascending order lie
// anywhere in memory.
class PairDistances {
 public:
  PairDistances(const PointsView& points, const PointsView& others)
      : points_(points), others_(others) {}

  // Of one of the sorted pairs, none of which after it is overwritten; nothing where there is no
  // column.
  void write(double* distances_m, std::size_t i, const Pair& pair,
             const core::SortedPairs& sorted) const;
  void write_row(double* distances_m, PointId id, const PointId* row, std::size_t length) const;

 private:
  void prepare(PointId other) const;

  PointsView points_;
  PointsView others_;
};

class PairColumnsAnswer final : public PairAnswer {
 public:
  PairColumnsAnswer(const PairRoom& room, const PointsView& points, const PointsView& others)
      : room_(room), distances_(points, others) {}

  void open(std::uint64_t size, const core::Resources& with) override;
  Pair* place() override { return reinterpret_cast<Pair*>(columns_.second); }
  void take(const core::SortedPairs& sorted) override;
  void take_row(std::uint64_t begin, PointId id, const PointId* row, std::size_t length) override;

 private:
  const PairRoom& room_;
  PairDistances distances_;
  PairColumns columns_;
};

class RowColumnsAnswer final : public PairAnswer {
 public:
  RowColumnsAnswer(const RowRoom& room, const PointsView& points, const PointsView& others)
      : room_(room), row_count_(points.size()), distances_(points, others) {}

  void open(std::uint64_t size, const core::Resources& with) override;
  Pair* place() override { return reinterpret_cast<Pair*>(columns_.ids); }
  void take(const core::SortedPairs& sorted) override;
  void take_row(std::uint64_t begin, PointId id, const PointId* row, std::size_t length) override;

 private:
  const RowRoom& room_;
  std::size_t row_count_;
  PairDistances distances_;
  RowColumns columns_;
};

}  // namespace beespace::search
