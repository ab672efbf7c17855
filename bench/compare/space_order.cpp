#include "bench/compare/space_order.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace beespace::compare {
namespace {

struct Keyed {
  std::uint64_t key = 0;
  PointId id = 0;
};

constexpr double kCellsPerAxis = 2'097'151.0;

// Two zero bits between each two of the 21 lowest bits.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | (bits << 32u)) & 0x001F'0000'0000'FFFFu;
  bits = (bits | (bits << 16u)) & 0x001F'0000'FF00'00FFu;
  bits = (bits | (bits << 8u)) & 0x100F'00F0'0F00'F00Fu;
  bits = (bits | (bits << 4u)) & 0x10C3'0C30'C30C'30C3u;
  return (bits | (bits << 2u)) & 0x1249'2492'4924'9249u;
}

// Least significant digit first; 11 bits a digit. The lowest 20 bits of the key are left unsorted:
// their effect is too small to measure.
void sort_by_key(std::vector<Keyed>& entries) {
  constexpr unsigned kDigitBits = 11;
  constexpr unsigned kKeyBits = 63;
  std::vector<Keyed> other(entries.size());
  for (unsigned shift = kKeyBits - 4 * kDigitBits; shift < kKeyBits; shift += kDigitBits) {
    std::array<std::size_t, std::size_t{1} << kDigitBits> starts{};
    const auto digit = [shift](const Keyed& entry) {
      return (entry.key >> shift) & ((1u << kDigitBits) - 1);
    };
    for (const Keyed& entry : entries) ++starts[digit(entry)];
    std::size_t sum = 0;
    for (std::size_t& start : starts) sum += std::exchange(start, sum);
    for (const Keyed& entry : entries) other[starts[digit(entry)]++] = entry;
    entries.swap(other);
  }
}

}  // namespace

std::vector<PointId> space_order(std::span<const Point> points) {
  if (points.empty()) return {};
  Point low = points.front();
  Point high = low;
  for (const Point& point : points) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
  }
  const double side = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double scale = side > 0.0 ? kCellsPerAxis / side : 0.0;
  const auto cell = [scale](double coordinate, double start) {
    return spread(static_cast<std::uint64_t>((coordinate - start) * scale));
  };
  std::vector<Keyed> entries(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& point = points[i];
    entries[i] = {
        cell(point.x, low.x) | (cell(point.y, low.y) << 1u) | (cell(point.z, low.z) << 2u),
        static_cast<PointId>(i)};
  }
  sort_by_key(entries);
  std::vector<PointId> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = entries[i].id;
  return order;
}

}  // namespace beespace::compare
