#include "index/place_order.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace beespace::search {

namespace {

constexpr unsigned kBitsAnAxis = 10;
constexpr double kCellsAnAxis = 1U << kBitsAnAxis;

struct Keyed {
  std::uint32_t key;
  std::uint32_t index;
};

// Two zeros before each of the lowest ten bits.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16U) & 0x030000FFU;
  bits = (bits | bits << 8U) & 0x0300F00FU;
  bits = (bits | bits << 4U) & 0x030C30C3U;
  bits = (bits | bits << 2U) & 0x09249249U;
  return bits;
}

// Sorts by bits [shift, shift + 10) of the key; equal ones stay in their order.
void sort_by_digit(const std::vector<Keyed>& from, std::vector<Keyed>& to, unsigned shift) {
  constexpr std::uint32_t kDigits = 1U << kBitsAnAxis;
  std::array<std::size_t, kDigits> next{};
  const auto digit = [shift](const Keyed& keyed) { return keyed.key >> shift & (kDigits - 1); };
  for (const Keyed& keyed : from) ++next[digit(keyed)];
  std::size_t before = 0;
  for (std::size_t& place : next) before += std::exchange(place, before);
  for (const Keyed& keyed : from) to[next[digit(keyed)]++] = keyed;
}

}  // namespace

OrderedPlaces place_order(const PointsView& places, const core::Bounds& bounds, Crew& crew) {
  std::array<double, 3> cells_a_metre{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double width = bounds.high[axis] - bounds.low[axis];
    cells_a_metre[axis] = width > 0.0 ? kCellsAnAxis / width : 0.0;
  }
  std::vector<Keyed> keyed(places.size());
  crew.split(places.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      std::uint32_t key = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double cell = (places.coordinate(axis, i) - bounds.low[axis]) * cells_a_metre[axis];
        const auto whole = static_cast<std::uint32_t>(std::min(cell, kCellsAnAxis - 1.0));
        key |= spread(whole) << axis;
      }
      keyed[i] = {key, static_cast<std::uint32_t>(i)};
    }
  });
  std::vector<Keyed> other(places.size());
  for (unsigned shift = 0; shift < 3 * kBitsAnAxis; shift += kBitsAnAxis) {
    sort_by_digit(keyed, other, shift);
    keyed.swap(other);
  }
  OrderedPlaces ordered{std::vector<Point>(places.size()),
                        std::vector<std::uint32_t>(places.size())};
  crew.split(places.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      ordered.index[i] = keyed[i].index;
      ordered.places[i] = places[keyed[i].index];
    }
  });
  return ordered;
}

}  // namespace beespace::search
