#include "grid/sorted_grid.hpp"

#include "grid/bucket_sort.hpp"
#include "grid/cell_order.hpp"

#include <algorithm>

namespace beespace::core {

namespace {

struct RowStart {
  std::uint32_t begin;
  std::uint64_t number;
};

// Adds the rows that start among the points [begin, end). Where `one_row` says that all of these
// are in one row, only the first is looked at.
void add_rows(const SortedGrid& grid, const CellOrder& order, std::uint32_t begin,
              std::uint32_t end, bool one_row, Vector<RowStart>& rows) {
  if (begin == end) return;
  const std::uint32_t last = one_row ? begin + 1 : end;
  std::uint64_t row = rows.empty() ? ~std::uint64_t{0} : rows.back().number;
  for (std::uint32_t i = begin; i < last; ++i) {
    const std::uint64_t number = order.row(grid.y[i], grid.z[i]);
    if (number == row) continue;
    row = number;
    rows.push_back({i, number});
  }
}

void join_rows(SortedGrid& grid, const PerWorker<RowStart>& parts) {
  std::size_t count = 0;
  for (std::size_t worker = 0; worker < parts.size(); ++worker) count += parts[worker].size();
  grid.row_begin.reserve(count + 1);
  grid.row_number.reserve(count);
  for (std::size_t worker = 0; worker < parts.size(); ++worker) {
    for (const RowStart& row : parts[worker]) {
      if (!grid.row_number.empty() && grid.row_number.back() == row.number) continue;
      grid.row_begin.push_back(row.begin);
      grid.row_number.push_back(row.number);
    }
  }
  grid.row_begin.push_back(static_cast<std::uint32_t>(grid.size));
}

// Prefetches a bucket, and its destination, while the one before it is sorted.
void prefetch(const Buckets& buckets, std::size_t bucket, const SortedArrays& to) {
  constexpr std::uint32_t kMost = 1024;
  constexpr std::uint32_t kRecordsALine = 64 / sizeof(CellRecord);
  const std::uint32_t begin = buckets.begin[bucket];
  const std::uint32_t end = std::min(buckets.begin[bucket + 1], begin + kMost);
  for (std::uint32_t i = begin; i < end; i += kRecordsALine) {
    __builtin_prefetch(buckets.records.data() + i);
  }
  for (std::uint32_t i = begin; i < end; i += 64 / sizeof(PointId)) {
    __builtin_prefetch(to.x + i, 1);
    __builtin_prefetch(to.y + i, 1);
    __builtin_prefetch(to.z + i, 1);
    __builtin_prefetch(to.id + i, 1);
  }
}

}  // namespace

SortedGrid sort_into_grid(const Selection& selected, const Lattice& lattice, unsigned row_shift,
                          const Resources& with) {
  const CellOrder order(lattice, row_shift);
  SortedGrid grid(with.memory);
  grid.size = selected.size();
  grid.fraction_bits = lattice.fraction_bits();
  grid.row_shift = row_shift;
  grid.slice_bits = order.slice_bits();
  grid.units_per_m = lattice.units_per_m();
  grid.rows_a_layer = order.rows_a_layer();

  Buckets buckets = scatter_into_buckets(selected, lattice, order, with);
  const std::size_t padded = grid.size + kPadding;
  grid.storage = Buffer<std::int32_t>(with.memory, 4 * padded);
  grid.x = grid.storage.data();
  grid.y = grid.x + padded;
  grid.z = grid.y + padded;
  grid.id = reinterpret_cast<PointId*>(grid.z + padded);  // int's twin may share its memory
  const SortedArrays arrays{grid.x, grid.y, grid.z, grid.id};
  const bool bucket_in_row = buckets.low_bits <= order.x_key_bits();

  PerWorker<RowStart> rows(with);
  with.crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    // A worker sorts the buckets that start in its share.
    const auto start_in = [&](std::size_t point) {
      const auto& starts = buckets.begin;
      return static_cast<std::size_t>(std::lower_bound(starts.begin(), starts.end() - 1, point) -
                                      starts.begin());
    };
    const std::size_t first = start_in(begin);
    const std::size_t last = end == grid.size ? buckets.begin.size() - 1 : start_in(end);
    BucketSorter sorter(order, buckets.records, arrays, with.memory.of(worker));
    for (std::size_t bucket = first; bucket < last; ++bucket) {
      const std::uint32_t from = buckets.begin[bucket];
      const std::uint32_t to = buckets.begin[bucket + 1];
      if (bucket + 1 < last) prefetch(buckets, bucket + 1, arrays);
      sorter.sort(from, to - from, buckets.low_bits);
      add_rows(grid, order, from, to, bucket_in_row, rows[worker]);
    }
  });
  buckets.records = Buffer<CellRecord>();  // rows take memory of their own
  join_rows(grid, rows);
  for (std::size_t i = grid.size; i < padded; ++i) {
    grid.x[i] = grid.y[i] = grid.z[i] = 0;
    grid.id[i] = 0;
  }
  return grid;
}

}  // namespace beespace::core
