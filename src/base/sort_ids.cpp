#include "base/sort_ids.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace beespace::core {

namespace {

constexpr unsigned kDigits = sizeof(PointId);

// Below this, insertion is done before counters are cleared.
constexpr std::size_t kFewIds = 24;

// Up to this many, about as many buckets as ids, which leave next to nothing to be sorted, are
// faster than a pass a digit.
constexpr std::size_t kMostSpread = 160;
constexpr std::size_t kFullBucket = 16;

void insert_in_order(PointId* ids, std::size_t count) {
  for (std::size_t i = 1; i < count; ++i) {
    const PointId id = ids[i];
    std::size_t place = i;
    for (; place > 0 && ids[place - 1] > id; --place) ids[place] = ids[place - 1];
    ids[place] = id;
  }
}

// Sorts ids that are spread evenly over their range, into `to`; returns whether they are.
bool sort_spread_ids(const PointId* ids, PointId* to, std::size_t count) {
  PointId lowest = ids[0];
  PointId highest = ids[0];
  for (std::size_t i = 1; i < count; ++i) {
    lowest = std::min(lowest, ids[i]);
    highest = std::max(highest, ids[i]);
  }
  const auto range_bits = static_cast<unsigned>(std::bit_width(highest - lowest));
  const auto wanted_bits = static_cast<unsigned>(std::bit_width(count));
  const unsigned shift = range_bits - std::min(range_bits, wanted_bits);
  const std::size_t buckets = std::size_t{1} << std::min(range_bits, wanted_bits);
  std::array<std::uint16_t, std::bit_ceil(kMostSpread)> next;
  std::fill_n(next.begin(), buckets, std::uint16_t{0});
  for (std::size_t i = 0; i < count; ++i) ++next[(ids[i] - lowest) >> shift];
  std::uint16_t fullest = 0;
  std::uint16_t before = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    fullest = std::max(fullest, next[bucket]);
    before = static_cast<std::uint16_t>(before + std::exchange(next[bucket], before));
  }
  if (fullest > kFullBucket) return false;
  for (std::size_t i = 0; i < count; ++i) to[next[(ids[i] - lowest) >> shift]++] = ids[i];
  insert_in_order(to, count);
  return true;
}

using Counts = std::array<std::array<std::uint32_t, 256>, kDigits>;

std::size_t digit_of(PointId id, unsigned digit) {
  return id >> (8 * digit) & 0xFFU;
}

Counts count_digits(const PointId* ids, std::size_t count) {
  Counts counts{};
  for (std::size_t i = 0; i < count; ++i) {
    for (unsigned digit = 0; digit < kDigits; ++digit) ++counts[digit][digit_of(ids[i], digit)];
  }
  return counts;
}

}  // namespace

PointId* sort_ids(PointId* ids, PointId* spare, std::size_t count) {
  if (count <= kFewIds) {
    insert_in_order(ids, count);
    return ids;
  }
  if (count <= kMostSpread && sort_spread_ids(ids, spare, count)) return spare;
  // By the lowest digit first; digits that all ids share are left out.
  PointId* from = ids;
  PointId* to = spare;
  Counts counts = count_digits(from, count);
  for (unsigned digit = 0; digit < kDigits; ++digit) {
    auto& next = counts[digit];
    if (next[digit_of(from[0], digit)] == count) continue;
    std::uint32_t before = 0;
    for (std::uint32_t& place : next) before += std::exchange(place, before);
    for (std::size_t i = 0; i < count; ++i) to[next[digit_of(from[i], digit)]++] = from[i];
    std::swap(from, to);
  }
  return from;
}

void sort_ids(std::vector<PointId>& ids, std::size_t count) {
  if (count > kFewIds && ids.size() < 2 * count) ids.resize(2 * count);
  const PointId* const sorted = sort_ids(ids.data(), ids.data() + count, count);
  if (sorted != ids.data()) std::copy_n(sorted, count, ids.data());
  ids.resize(count);
}

}  // namespace beespace::core
