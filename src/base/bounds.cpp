#include "base/bounds.hpp"

#include "base/point_block.hpp"
#include "exact/validate.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

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

// Magnitudes above the domain show in low and high; a NaN shows here, as it is neither zero nor
// above anything.
struct ExtentLanes {
  Doubles low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Doubles high = -low;
  Masks outside{};

  void add(const double* values) {
    Doubles value;
    std::memcpy(&value, values, sizeof value);
    const Doubles magnitude = value < 0.0 ? -value : value;
    outside |= ~(magnitude >= kSmallestCoordinate_m) & (value != 0.0);
    low = value < low ? value : low;
    high = value > high ? value : high;
  }
};

using Extents = std::array<Extent, 3>;

void add_to(Extents& extents, const ExtentLanes& lanes, std::size_t lane, std::size_t axis) {
  extents[axis].low = std::min(extents[axis].low, lanes.low[lane]);
  extents[axis].high = std::max(extents[axis].high, lanes.high[lane]);
  extents[axis].valid &= lanes.outside[lane] == 0;
}

// x y z x y z ...: three vectors hold two points.
Extents extents_of_interleaved(const double* xyz, std::size_t count) {
  std::array<ExtentLanes, 3> lanes;
  std::size_t i = 0;
  for (; i + 2 <= count; i += 2, xyz += 6) {
    __builtin_prefetch(xyz + 512);
    for (std::size_t k = 0; k < 3; ++k) lanes[k].add(xyz + 2 * k);
  }
  Extents extents;
  for (std::size_t value = 0; value < 6; ++value) {
    add_to(extents, lanes[value / 2], value % 2, value % 3);
  }
  if (i < count) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::array<double, 2> twice{xyz[axis], xyz[axis]};
      ExtentLanes last;
      last.add(twice.data());
      add_to(extents, last, 0, axis);
    }
  }
  return extents;
}

Extents extents_of_any(const PointsView& points, std::size_t begin, std::size_t end) {
  Extents extents;
  PointBlock block;
  for_each_block(begin, end, [&](std::size_t first, std::size_t count) {
    block.load(points, first, count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ExtentLanes lanes;
      const double* values = block.axis(axis);
      std::size_t i = 0;
      for (; i + 2 <= count; i += 2) lanes.add(values + i);
      const std::array<double, 2> last{values[count - 1], values[count - 1]};
      lanes.add(last.data());
      add_to(extents, lanes, 0, axis);
      add_to(extents, lanes, 1, axis);
    }
  });
  return extents;
}

}  // namespace

Result<Bounds> measure(const PointsView& points, const Resources& with) {
  Bounds bounds;
  if (points.empty()) return bounds;
  Vector<Extents> parts(with.crew.size(), &with.memory);
  with.crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    const std::optional<Interleaved> given = interleaved(points);
    if (!given) {
      parts[worker] = extents_of_any(points, begin, end);
      return;
    }
    const Extents extents = extents_of_interleaved(given->xyz + 3 * begin, end - begin);
    for (std::size_t axis = 0; axis < 3; ++axis) parts[worker][axis] = extents[given->place[axis]];
  });
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Extent whole;
    for (const auto& part : parts) {
      whole.low = std::min(whole.low, part[axis].low);
      whole.high = std::max(whole.high, part[axis].high);
      whole.valid &= part[axis].valid;
    }
    whole.valid &= whole.low >= -kLargestCoordinate_m && whole.high <= kLargestCoordinate_m;
    if (!whole.valid) return *check_points(points, 0, points.size());
    bounds.low[axis] = whole.low;
    bounds.high[axis] = whole.high;
  }
  return bounds;
}

}  // namespace beespace::core
