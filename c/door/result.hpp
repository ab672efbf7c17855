// What is behind beespace_result: columns that are written by a search and read in place.
#pragma once

#include <beespace.h>
#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/nearest.hpp>
#include <beespace/pairs.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>

namespace beespace::c {

// Numbers that are all written after resize(), so that they need not be zero before. Memory is
// kept.
template <class Number>
class Column {
 public:
  void resize(std::size_t size) {
    if (size > capacity_) {
      numbers_.reset();  // first: never two at once
      capacity_ = 0;
      numbers_ = std::make_unique_for_overwrite<Number[]>(size);
      capacity_ = size;
    }
    size_ = size;
  }
  void clear() { size_ = 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Number* data() { return numbers_.get(); }
  [[nodiscard]] const Number* data() const { return size_ == 0 ? nullptr : numbers_.get(); }
  Number& operator[](std::size_t index) { return numbers_[index]; }

 private:
  std::unique_ptr<Number[]> numbers_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace beespace::c

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_result {
  beespace::c::Column<std::int64_t> ids;
  beespace::c::Column<std::int64_t> offsets;
  beespace::c::Column<std::int64_t> first;
  beespace::c::Column<std::int64_t> second;
  beespace::c::Column<std::int64_t> counts;
  beespace::c::Column<double> distances_m;
  beespace::c::Column<double> begins_s;
  beespace::c::Column<double> closest_s;
  beespace::c::Column<double> ends_s;
  beespace::c::Column<std::int64_t> gap_agents;
  beespace::c::Column<double> gap_begins_s;
  beespace::c::Column<double> gap_ends_s;

  void clear();
};

namespace beespace::c {

// Each writes one answer into an empty result. Ids of C are 64 bits wide. What may be gigabytes
// ends early, with an error, where a stop is requested.
void write_ids(std::span<const PointId> ids, beespace_result& result);
void write_counts(std::span<const std::uint32_t> counts, bool with_self, beespace_result& result);
Status write_pairs(std::span<const Pair> pairs, const std::stop_token& stop,
                   beespace_result& result);
Status write_rows(const IdRows& rows, std::size_t row_count, const std::stop_token& stop,
                  beespace_result& result);
Status write_conflicts(std::span<const Conflict> conflicts, const std::stop_token& stop,
                       beespace_result& result);
void write_gaps(std::span<const Gap> gaps, beespace_result& result);
// Each row with the number of the row itself among its ids.
Status write_rows_with_self(const IdRows& rows, std::size_t row_count, const std::stop_token& stop,
                            beespace_result& result);
// One entry for each point: -1 and infinity where there is none.
Status write_nearest(std::span<const Nearest> nearest, const std::stop_token& stop,
                     beespace_result& result);
Status write_nearest_rows(std::span<const Nearest> entries, std::size_t length,
                          std::size_t row_count, const std::stop_token& stop,
                          beespace_result& result);

// The distances of each row's point and the row's ids, which are in the result.
Status write_row_distances(const PointsView& points, const PointsView& others,
                           const std::stop_token& stop, beespace_result& result);

}  // namespace beespace::c
