// Brings points into the order of a grid, in two steps that suit the caches: one scatter of
// everything into some thousand buckets, then each bucket on its own, in the nearest cache.
#pragma once

#include "base/buffer.hpp"
#include "base/point_block.hpp"
#include "base/resources.hpp"
#include "grid/cell_order.hpp"
#include "grid/lattice.hpp"

#include <cstdint>

namespace beespace::core {

// Points by the high bits of their keys.
struct Buckets {
  unsigned low_bits;  // key bits that the points of a bucket are still to be sorted by
  Buffer<CellRecord> records;
  Vector<std::uint32_t> begin;  // bucket b: [begin[b], begin[b + 1])
};

Buckets scatter_into_buckets(const Selection& selected, const Lattice& lattice,
                             const CellOrder& order, const Resources& with);

// The arrays of sorted points: one a property.
struct SortedArrays {
  std::int32_t* x;
  std::int32_t* y;
  std::int32_t* z;
  PointId* id;

  void put(std::size_t place, const CellRecord& record) const {
    x[place] = record.position[0];
    y[place] = record.position[1];
    z[place] = record.position[2];
    id[place] = record.id;
  }
};

// Sorts buckets one by one, each from its place in `records` to the same place in `to`; what it
// leaves in `records` is of no use. One for each worker.
class BucketSorter {
 public:
  BucketSorter(const CellOrder& order, Buffer<CellRecord>& records, const SortedArrays& to,
               Memory& memory)
      : order_(order), records_(records.data()), to_(to), spare_(memory, kLarge) {}

  // The points [first, first + size), which differ in the `bits` low bits of their keys only.
  void sort(std::size_t first, std::size_t size, unsigned bits);

 private:
  // A bucket that is larger (a crowd in a wide space) is split in place until it is not.
  static constexpr std::size_t kLarge = std::size_t{1} << 15;

  void sort_by_digits(std::size_t first, std::size_t size, unsigned bits);
  template <class DigitOf>
  void pass(const CellRecord* from, std::size_t size, unsigned digit_bits, bool last,
            std::size_t first, CellRecord* spare, const DigitOf& digit_of);
  void split(std::size_t first, std::size_t size, unsigned bits);

  CellOrder order_;
  CellRecord* records_;
  SortedArrays to_;
  Buffer<CellRecord> spare_;
};

}  // namespace beespace::core
