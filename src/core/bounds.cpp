#include "core/bounds.hpp"

#include "core/point_block.hpp"
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

// Lanes that do not depend on each other, so that the compiler can vectorise: it must not reorder
// minima by itself. The domain is an interval of magnitude bits, and zero.
struct LanesOfExtent {
  static constexpr std::size_t kLanes = 8;
  std::array<double, kLanes> low;
  std::array<double, kLanes> high;
  std::array<std::uint64_t, kLanes> outside{};

  LanesOfExtent() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }

  void add(std::size_t lane, double value) {
    constexpr auto kSmallest = std::bit_cast<std::int64_t>(kSmallestCoordinate_m);
    constexpr auto kLargest = std::bit_cast<std::int64_t>(kLargestCoordinate_m);
    constexpr std::int64_t kMagnitude = std::numeric_limits<std::int64_t>::max();
    const std::int64_t magnitude = std::bit_cast<std::int64_t>(value) & kMagnitude;
    // Negative when below the smallest, or above the largest; for zero only the first, undone.
    const std::int64_t small = (magnitude - kSmallest) & -static_cast<std::int64_t>(magnitude != 0);
    outside[lane] |= static_cast<std::uint64_t>(small | (kLargest - magnitude));
    low[lane] = value < low[lane] ? value : low[lane];
    high[lane] = value > high[lane] ? value : high[lane];
  }
};

Extent extent_of(const double* values, std::size_t count) {
  LanesOfExtent lanes;
  std::size_t i = 0;
  for (; i + LanesOfExtent::kLanes <= count; i += LanesOfExtent::kLanes) {
    for (std::size_t lane = 0; lane < LanesOfExtent::kLanes; ++lane)
      lanes.add(lane, values[i + lane]);
  }
  for (; i < count; ++i) lanes.add(0, values[i]);

  Extent extent;
  std::uint64_t outside = 0;
  for (std::size_t lane = 0; lane < LanesOfExtent::kLanes; ++lane) {
    extent.low = std::min(extent.low, lanes.low[lane]);
    extent.high = std::max(extent.high, lanes.high[lane]);
    outside |= lanes.outside[lane];
  }
  extent.valid = (outside >> 63) == 0;
  return extent;
}

}  // namespace

Result<Bounds> measure(const PointsView& points, Crew& crew) {
  Bounds bounds;
  if (points.empty()) return bounds;
  std::vector<std::array<Extent, 3>> parts(crew.size());
  crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::array<Extent, 3> mine;
    PointBlock block;
    for_each_block(begin, end, [&](std::size_t first, std::size_t count) {
      block.load(points, first, count);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Extent extent = extent_of(block.axis(axis), count);
        mine[axis].low = std::min(mine[axis].low, extent.low);
        mine[axis].high = std::max(mine[axis].high, extent.high);
        mine[axis].valid &= extent.valid;
      }
    });
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
