#include "core/bounds.hpp"

#include "core/validate.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::core {

namespace {

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  bool valid = true;
};

// Branch-free, so that the compiler can vectorise it: the domain is an interval of magnitude bits,
// and zero.
Extent extent_of(const PointsView& points, std::size_t axis, std::size_t begin, std::size_t end) {
  constexpr auto kSmallest = std::bit_cast<std::uint64_t>(kSmallestCoordinate_m);
  constexpr auto kLargest = std::bit_cast<std::uint64_t>(kLargestCoordinate_m);
  Extent extent;
  std::uint64_t outside = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const double value = points.coordinate(axis, i);
    const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(value) << 1 >> 1;
    outside |= static_cast<std::uint64_t>(magnitude - kSmallest > kLargest - kSmallest) &
               static_cast<std::uint64_t>(magnitude != 0);
    extent.low = value < extent.low ? value : extent.low;
    extent.high = value > extent.high ? value : extent.high;
  }
  extent.valid = outside == 0;
  return extent;
}

}  // namespace

Result<Bounds> measure(const PointsView& points, Crew& crew) {
  Bounds bounds;
  if (points.empty()) return bounds;
  constexpr std::size_t kBlock = 1024;  // stays in the L1 cache for the three axes
  std::vector<std::array<Extent, 3>> parts(crew.size());
  crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::array<Extent, 3> mine;
    for (std::size_t block = begin; block < end; block += kBlock) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Extent extent = extent_of(points, axis, block, std::min(block + kBlock, end));
        mine[axis].low = std::min(mine[axis].low, extent.low);
        mine[axis].high = std::max(mine[axis].high, extent.high);
        mine[axis].valid &= extent.valid;
      }
    }
    parts[worker] = mine;
  });
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Extent whole;
    for (const auto& part : parts) {
      whole.low = std::min(whole.low, part[axis].low);
      whole.high = std::max(whole.high, part[axis].high);
      whole.valid &= part[axis].valid;
    }
    if (!whole.valid) return *check_points(points, 0, points.size());
    bounds.low[axis] = whole.low;
    bounds.high[axis] = whole.high;
  }
  return bounds;
}

}  // namespace beespace::core
