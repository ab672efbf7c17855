#include "core/bounds.hpp"

#include "core/point_block.hpp"
#include "core/validate.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace beespace::core {

namespace {

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  bool valid = true;
};

// GNU vectors, because a compiler must not reorder minima by itself: SSE2 on x86-64, NEON on ARM64.
using Doubles [[gnu::vector_size(16)]] = double;
using Masks [[gnu::vector_size(16)]] = std::int64_t;
constexpr std::size_t kLanes = 2;

// Written with masks, which every compiler turns into the two or three instructions that they are.
Doubles select(const Masks& chosen, const Doubles& yes, const Doubles& no) {
  return std::bit_cast<Doubles>((std::bit_cast<Masks>(yes) & chosen) |
                                (std::bit_cast<Masks>(no) & ~chosen));
}

// Magnitudes above the domain show in low and high; a NaN shows here, as it is neither zero nor
// above anything.
struct ExtentLanes {
  Doubles low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Doubles high = -low;
  Masks outside{};

  void add(const double* values) {
    Doubles value;
    std::memcpy(&value, values, sizeof value);
    constexpr std::int64_t kMagnitude = std::numeric_limits<std::int64_t>::max();
    const Doubles magnitude = std::bit_cast<Doubles>(std::bit_cast<Masks>(value) & kMagnitude);
    outside |= ~(magnitude >= kSmallestCoordinate_m) & (value != 0.0);
    low = select(value < low, value, low);
    high = select(value > high, value, high);
  }
};

Extent extent_of(const double* values, std::size_t count) {
  ExtentLanes even;
  ExtentLanes odd;
  std::size_t i = 0;
  for (; i + 2 * kLanes <= count; i += 2 * kLanes) {
    even.add(values + i);
    odd.add(values + i + kLanes);
  }
  for (; i < count; ++i) {
    const std::array<double, kLanes> twice{values[i], values[i]};
    even.add(twice.data());
  }
  const Masks outside = even.outside | odd.outside;
  Extent extent;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    extent.low = std::min({extent.low, even.low[lane], odd.low[lane]});
    extent.high = std::max({extent.high, even.high[lane], odd.high[lane]});
    extent.valid &= outside[lane] == 0;
  }
  extent.valid &= extent.low >= -kLargestCoordinate_m && extent.high <= kLargestCoordinate_m;
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
