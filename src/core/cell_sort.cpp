#include "core/cell_sort.hpp"

#include "core/point_block.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace beespace::core {

namespace {

// 2048 open write streams fit the L2 cache and, on huge pages, the translation buffer.
constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;

// Within a bucket of some hundred points, counters must not outnumber the points.
constexpr unsigned kLowDigitBits = 8;

// Below this, a comparison sort is done before a counting sort has cleared its counters.
constexpr std::size_t kFew = 64;

// Writes the records of the points [begin, end) of the search, or of its subset, to
// records[begin, end).
void make_records(const PointsView& points, std::span<const PointId> subset, const Lattice& lattice,
                  std::size_t begin, std::size_t end, CellRecord* records) {
  if (!subset.empty()) {
    for (std::size_t i = begin; i < end; ++i) {
      const Point p = points[subset[i]];
      records[i] = {{lattice.position(0, p.x), lattice.position(1, p.y), lattice.position(2, p.z)},
                    subset[i]};
    }
    return;
  }
  for_each_position_block(
      points, lattice, begin, end,
      [&](const PositionBlock& positions, std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
          records[first + i] = {{positions[0][i], positions[1][i], positions[2][i]},
                                static_cast<PointId>(first + i)};
        }
      });
}

// One stable counting pass over [from, from + size) by the key's digit at `shift`.
void pass(const CellRecord* from, CellRecord* to, std::size_t size, const CellOrder& order,
          unsigned shift, unsigned digit_bits) {
  constexpr std::size_t kRemembered = 2048;  // digits are worked out once, for buckets up to this
  const CellOrder by = order;                // a copy that no store can be suspected of changing
  const std::size_t mask = (std::size_t{1} << digit_bits) - 1;
  const auto digit_of = [&](std::size_t i) { return by.key(from[i], shift) & mask; };
  std::array<std::uint32_t, std::size_t{1} << kLowDigitBits> next;
  std::array<std::uint8_t, kRemembered> digits;
  static_assert(kLowDigitBits <= 8);
  std::fill_n(next.begin(), mask + 1, 0U);
  const bool remember = size <= kRemembered;
  if (remember) {
    for (std::size_t i = 0; i < size; ++i) digits[i] = static_cast<std::uint8_t>(digit_of(i));
    for (std::size_t i = 0; i < size; ++i) ++next[digits[i]];
  } else {
    for (std::size_t i = 0; i < size; ++i) ++next[digit_of(i)];
  }
  std::uint32_t sum = 0;
  for (std::size_t digit = 0; digit <= mask; ++digit) sum += std::exchange(next[digit], sum);
  if (remember) {
    for (std::size_t i = 0; i < size; ++i) to[next[digits[i]]++] = from[i];
  } else {
    for (std::size_t i = 0; i < size; ++i) to[next[digit_of(i)]++] = from[i];
  }
}

// How a bucket is sorted: `passes` counting passes, to and fro between two buffers.
struct Passes {
  unsigned bits;  // the low key bits that are still to be sorted by
  unsigned passes;
  unsigned digit_bits;

  explicit Passes(unsigned low_bits)
      : bits(low_bits),
        passes((bits + kLowDigitBits - 1) / kLowDigitBits),
        digit_bits(passes == 0 ? 0 : (bits + passes - 1) / passes) {}

  [[nodiscard]] bool ends_where_it_began() const { return passes % 2 == 0; }
};

void sort_bucket(CellRecord* from, CellRecord* other, std::size_t size, const CellOrder& order,
                 const Passes& passes) {
  if (size <= kFew) {
    if (passes.bits != 0) std::stable_sort(from, from + size, order);
    if (!passes.ends_where_it_began()) std::copy_n(from, size, other);
    return;
  }
  for (unsigned done = 0; done < passes.passes; ++done) {
    const unsigned shift = done * passes.digit_bits;
    pass(from, other, size, order, shift, std::min(passes.digit_bits, passes.bits - shift));
    std::swap(from, other);
  }
}

}  // namespace

SortedCells sort_by_cell(const PointsView& points, std::span<const PointId> subset,
                         const Lattice& lattice, const CellOrder& order, std::size_t room,
                         Crew& crew) {
  const std::size_t size = subset.empty() ? points.size() : subset.size();
  const unsigned low_bits = order.key_bits() - std::min(order.key_bits(), kDigitBits);
  const auto bucket_of = [order, low_bits](const CellRecord& record) {
    return static_cast<std::size_t>(order.key(record, low_bits));
  };

  Buffer<CellRecord> records(size + room);
  std::vector<std::uint32_t> next(kDigits * crew.size());  // [worker][bucket]
  crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::uint32_t* counts = next.data() + worker * kDigits;
    const auto bucket = bucket_of;  // a copy that no store can be suspected of changing
    for_each_block(begin, end, [&](std::size_t first, std::size_t count) {
      make_records(points, subset, lattice, first, first + count, records.data());
      for (std::size_t i = first; i < first + count; ++i) ++counts[bucket(records[i])];
    });
  });
  std::vector<std::uint32_t> bucket_begin(kDigits + 1);
  std::uint32_t sum = 0;
  for (std::size_t bucket = 0; bucket < kDigits; ++bucket) {
    bucket_begin[bucket] = sum;
    for (std::size_t worker = 0; worker < crew.size(); ++worker) {
      sum += std::exchange(next[worker * kDigits + bucket], sum);
    }
  }
  bucket_begin[kDigits] = sum;

  Buffer<CellRecord> scattered(size + room);
  crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::uint32_t* places = next.data() + worker * kDigits;
    const auto bucket = bucket_of;
    const CellRecord* from = records.data();
    CellRecord* to = scattered.data();
    for (std::size_t i = begin; i < end; ++i) to[places[bucket(from[i])]++] = from[i];
  });

  const Passes passes(low_bits);
  crew.split(size, [&](std::size_t begin, std::size_t end, unsigned) {
    // A worker sorts the buckets that start in its share.
    const auto first = std::lower_bound(bucket_begin.begin(), bucket_begin.end() - 1, begin);
    for (auto bucket = first; bucket + 1 != bucket_begin.end() && *bucket < end; ++bucket) {
      sort_bucket(scattered.data() + *bucket, records.data() + *bucket, bucket[1] - bucket[0],
                  order, passes);
    }
  });
  if (passes.ends_where_it_began()) std::swap(records, scattered);
  return {std::move(records), std::move(scattered)};
}

}  // namespace beespace::core
