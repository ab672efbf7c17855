#include "grid/bucket_sort.hpp"

#include "base/point_block.hpp"
#include "grid/position_block.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace beespace::core {

namespace {

// As many open write streams as the L2 cache and, on huge pages, the translation buffer bear; and
// buckets of some hundred points, which stay in the L1 cache.
constexpr unsigned kMostBucketBits = 12;
constexpr unsigned kPointsABucketBits = 9;

// More streams than that are still better than buckets of more points, which have to be split.
constexpr unsigned kMostPointsABucketBits = 13;

// Below this, a comparison sort is done before a counting sort has cleared its counters.
constexpr std::size_t kFewToSort = 32;

constexpr unsigned kMostDigitBits = 10;

unsigned bucket_bits_for(std::size_t size, unsigned key_bits) {
  const auto size_bits = static_cast<unsigned>(std::bit_width(size));
  const unsigned wanted = size_bits - std::min(size_bits, kPointsABucketBits);
  const unsigned least = size_bits - std::min(size_bits, kMostPointsABucketBits);
  return std::min({wanted, std::max(least, kMostBucketBits), key_bits});
}

// A record in one store, of which a processor bears far more in flight than of single words.
using Words [[gnu::vector_size(sizeof(CellRecord))]] = std::int32_t;

using BucketBlock = std::array<std::uint32_t, PointBlock::kSize>;

void find_buckets(const PositionBlock& at, std::size_t count, const CellOrder& order,
                  unsigned low_bits, BucketBlock& bucket) {
  const CellOrder by = order;  // a copy that no store can be suspected of changing
  if (low_bits >= by.x_key_bits()) {
    // Rows only; known before the loop, so that it is one of vectors.
    const unsigned down = low_bits - by.x_key_bits();
    for (std::size_t i = 0; i < count; ++i) {
      bucket[i] = static_cast<std::uint32_t>(by.row(at[1][i], at[2][i]) >> down);
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    bucket[i] = static_cast<std::uint32_t>(by.key(at[0][i], at[1][i], at[2][i], low_bits));
  }
}

constexpr std::size_t kRemembered = 4096;  // digits are computed once, for buckets up to this

// One stable counting pass; digit_of(record) is below 1 << digit_bits, and put(place, record) takes
// the result.
template <class DigitOf, class Put>
void counting_pass(const CellRecord* from, std::size_t size, unsigned digit_bits,
                   const DigitOf& digit_of_record, const Put& put) {
  const std::size_t mask = (std::size_t{1} << digit_bits) - 1;
  const auto digit_of = [&](std::size_t i) { return digit_of_record(from[i]); };
  std::array<std::uint32_t, std::size_t{1} << kMostDigitBits> next;
  std::array<std::uint16_t, kRemembered> digits;
  std::fill_n(next.begin(), mask + 1, 0U);
  const bool remember = size <= kRemembered;
  if (remember) {
    for (std::size_t i = 0; i < size; ++i) digits[i] = static_cast<std::uint16_t>(digit_of(i));
    for (std::size_t i = 0; i < size; ++i) ++next[digits[i]];
  } else {
    for (std::size_t i = 0; i < size; ++i) ++next[digit_of(i)];
  }
  std::uint32_t sum = 0;
  for (std::size_t digit = 0; digit <= mask; ++digit) sum += std::exchange(next[digit], sum);
  if (remember) {
    for (std::size_t i = 0; i < size; ++i) put(next[digits[i]]++, from[i]);
  } else {
    for (std::size_t i = 0; i < size; ++i) put(next[digit_of(i)]++, from[i]);
  }
}

}  // namespace

Buckets scatter_into_buckets(const Selection& selected, const Lattice& lattice,
                             const CellOrder& order, const Resources& with) {
  const std::size_t size = selected.size();
  const unsigned low_bits = order.key_bits() - bucket_bits_for(size, order.key_bits());
  const std::size_t buckets = std::size_t{1} << (order.key_bits() - low_bits);
  const unsigned workers = with.crew.size();

  Vector<std::uint32_t> next(buckets * workers, &with.memory);  // [worker][bucket]
  with.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::uint32_t* counts = next.data() + worker * buckets;
    BucketBlock bucket;
    for_each_position_block(selected, lattice, begin, end,
                            [&](const PositionBlock& at, std::size_t, std::size_t count) {
                              find_buckets(at, count, order, low_bits, bucket);
                              for (std::size_t i = 0; i < count; ++i) ++counts[bucket[i]];
                            });
  });

  Buckets result{low_bits, Buffer<CellRecord>(with.memory, size),
                 Vector<std::uint32_t>(buckets + 1, &with.memory)};
  std::uint32_t sum = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    result.begin[bucket] = sum;
    for (std::size_t worker = 0; worker < workers; ++worker) {
      sum += std::exchange(next[worker * buckets + bucket], sum);
    }
  }
  result.begin[buckets] = sum;

  with.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::uint32_t* places = next.data() + worker * buckets;
    CellRecord* to = result.records.data();
    BucketBlock bucket;
    for_each_position_block(selected, lattice, begin, end,
                            [&](const PositionBlock& at, std::size_t first, std::size_t count) {
                              find_buckets(at, count, order, low_bits, bucket);
                              // All lines of a block are asked for together, so that waiting for
                              // one is waiting for all.
                              for (std::size_t i = 0; i < count; ++i)
                                __builtin_prefetch(to + places[bucket[i]], 1);
                              for (std::size_t i = 0; i < count; ++i) {
                                const Words record{
                                    at[0][i], at[1][i], at[2][i],
                                    static_cast<std::int32_t>(selected.id(first + i))};
                                std::memcpy(&to[places[bucket[i]]++], &record, sizeof record);
                              }
                            });
  });
  return result;
}

void BucketSorter::sort(std::size_t first, std::size_t size, unsigned bits) {
  if (bits != 0 && size > kLarge) return split(first, size, bits);
  if (bits != 0 && size > kFewToSort) return sort_by_digits(first, size, bits);
  CellRecord* from = records_ + first;
  if (bits != 0) std::sort(from, from + size, order_);
  for (std::size_t i = 0; i < size; ++i) to_.put(first + i, from[i]);
}

void BucketSorter::sort_by_digits(std::size_t first, std::size_t size, unsigned bits) {
  // Counters must not outnumber the points by much.
  const unsigned most_digit_bits =
      std::clamp(static_cast<unsigned>(std::bit_width(size)), 6U, kMostDigitBits);
  const unsigned passes = (bits + most_digit_bits - 1) / most_digit_bits;
  const unsigned digit_bits = (bits + passes - 1) / passes;
  const CellRecord* from = records_ + first;
  CellRecord* spare = spare_.data();
  for (unsigned shift = 0; shift < bits; shift += digit_bits) {
    const unsigned digit = std::min(digit_bits, bits - shift);
    const bool last = shift + digit_bits >= bits;
    // Within a row the key is the slice, which is cheap to tell.
    if (shift + digit <= order_.x_key_bits()) {
      const unsigned down = order_.slice_bits() + shift;
      const std::uint32_t mask = (1U << digit) - 1;
      pass(from, size, digit, last, first, spare, [=](const CellRecord& record) {
        return static_cast<std::uint32_t>(record.position[0]) >> down & mask;
      });
    } else {
      const CellOrder order = order_;  // a copy that no store can be suspected of changing
      const std::uint64_t mask = (std::uint64_t{1} << digit) - 1;
      pass(from, size, digit, last, first, spare, [=](const CellRecord& record) {
        return static_cast<std::uint32_t>(order.key(record, shift) & mask);
      });
    }
    from = std::exchange(spare, const_cast<CellRecord*>(from));
  }
}

template <class DigitOf>
void BucketSorter::pass(const CellRecord* from, std::size_t size, unsigned digit_bits, bool last,
                        std::size_t first, CellRecord* spare, const DigitOf& digit_of) {
  if (!last) {
    counting_pass(from, size, digit_bits, digit_of,
                  [spare](std::size_t place, const CellRecord& record) { spare[place] = record; });
    return;
  }
  // By way of the records that are of no use any more, which are in a cache: four words here and
  // there in memory that is not would fill up what a processor has in flight.
  static_assert(sizeof(CellRecord) == 4 * sizeof(std::int32_t));
  auto* const words = reinterpret_cast<std::int32_t*>(spare);
  const SortedArrays near{words, words + size, words + 2 * size,
                          reinterpret_cast<PointId*>(words + 3 * size)};
  counting_pass(from, size, digit_bits, digit_of,
                [near](std::size_t place, const CellRecord& record) { near.put(place, record); });
  std::copy_n(near.x, size, to_.x + first);
  std::copy_n(near.y, size, to_.y + first);
  std::copy_n(near.z, size, to_.z + first);
  std::copy_n(near.id, size, to_.id + first);
}

// By the highest digit, in place: every record is swapped to where its digit's run goes on (the
// American flag sort of McIlroy, Bostic and McIlroy, 1993).
void BucketSorter::split(std::size_t first, std::size_t size, unsigned bits) {
  const unsigned digit_bits = std::min(bits, kMostDigitBits);
  const unsigned shift = bits - digit_bits;
  const std::size_t mask = (std::size_t{1} << digit_bits) - 1;
  CellRecord* records = records_ + first;
  const auto digit_of = [&](const CellRecord& record) { return order_.key(record, shift) & mask; };

  std::array<std::size_t, (std::size_t{1} << kMostDigitBits) + 1> begin{};
  for (std::size_t i = 0; i < size; ++i) ++begin[digit_of(records[i]) + 1];
  for (std::size_t digit = 0; digit <= mask; ++digit) begin[digit + 1] += begin[digit];
  std::array<std::size_t, (std::size_t{1} << kMostDigitBits) + 1> next = begin;
  for (std::size_t digit = 0; digit <= mask; ++digit) {
    while (next[digit] < begin[digit + 1]) {
      CellRecord moving = records[next[digit]];
      for (std::size_t to = digit_of(moving); to != digit; to = digit_of(moving)) {
        std::swap(moving, records[next[to]++]);
      }
      records[next[digit]++] = moving;
    }
  }
  for (std::size_t digit = 0; digit <= mask; ++digit) {
    sort(first + begin[digit], begin[digit + 1] - begin[digit], shift);
  }
}

}  // namespace beespace::core
