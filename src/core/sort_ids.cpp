#include "core/sort_ids.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace beespace::core {

namespace {

constexpr unsigned kDigits = sizeof(PointId);
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

void sort_ids(std::vector<PointId>& ids, std::size_t count) {
  constexpr std::size_t kFew = 128;
  if (count <= kFew) {
    ids.resize(count);
    std::sort(ids.begin(), ids.end());
    return;
  }
  // By the lowest digit first; digits that all ids share are left out.
  if (ids.size() < 2 * count) ids.resize(2 * count);
  PointId* from = ids.data();
  PointId* to = from + count;
  Counts counts = count_digits(from, count);
  for (unsigned digit = 0; digit < kDigits; ++digit) {
    auto& next = counts[digit];
    if (next[digit_of(from[0], digit)] == count) continue;
    std::uint32_t before = 0;
    for (std::uint32_t& place : next) before += std::exchange(place, before);
    for (std::size_t i = 0; i < count; ++i) to[next[digit_of(from[i], digit)]++] = from[i];
    std::swap(from, to);
  }
  if (from != ids.data()) std::copy_n(from, count, ids.data());
  ids.resize(count);
}

}  // namespace beespace::core
