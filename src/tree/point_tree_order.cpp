#include "tree/point_tree_order.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <utility>

namespace beespace::core {

namespace {

// A point on its way: where it lies in some frame, and which one it is.
struct Traveller {
  std::array<float, 3> at;
  std::uint32_t index;
};

// A point's exact coordinate, and where its traveller stands. Lies where a traveller lay.
struct ExactKey {
  double coordinate;
  std::size_t position;
};
static_assert(sizeof(ExactKey) == sizeof(Traveller));

// The part [begin, end) of the order that is still to be cut, into multiples of `unit` points.
// The travellers stand in `from`; `to` is free.
struct Part {
  Traveller* from;
  Traveller* to;
  std::size_t begin;
  std::size_t end;
  std::size_t unit;

  [[nodiscard]] std::size_t size() const { return end - begin; }
  [[nodiscard]] std::size_t units() const { return (size() + unit - 1) / unit; }
};

struct Extent {
  std::array<float, 3> low;
  std::array<float, 3> width;
};

struct Cuts {
  std::size_t axis;
  std::size_t count;                        // of slabs
  std::array<std::size_t, kFanOut + 1> at;  // at[0] = begin, at[count] = end
};

using Floats [[gnu::vector_size(16)]] = float;
using Masks [[gnu::vector_size(16)]] = std::int32_t;

Floats select(const Masks& chosen, const Floats& yes, const Floats& no) {
  return std::bit_cast<Floats>((std::bit_cast<Masks>(yes) & chosen) |
                               (std::bit_cast<Masks>(no) & ~chosen));
}

// The lane of the index is along for the ride.
Extent measure(const Traveller* travellers, std::size_t count) {
  Floats low;
  std::memcpy(&low, travellers, sizeof low);
  Floats high = low;
  for (std::size_t i = 1; i < count; ++i) {
    Floats value;
    std::memcpy(&value, travellers + i, sizeof value);
    low = select(value < low, value, low);
    high = select(value > high, value, high);
  }
  return {{low[0], low[1], low[2]}, {high[0] - low[0], high[1] - low[1], high[2] - low[2]}};
}

// Places travellers in the frame of a box: [-1, 1] on the widest axis. False, with nothing done,
// when the box is a single place.
bool place_in_frame(const PointsView& points, Traveller* travellers, std::size_t count,
                    const Bounds& bounds) {
  std::array<double, 3> middle{};
  double half_width = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double half = (bounds.high[axis] - bounds.low[axis]) / 2;
    middle[axis] = bounds.low[axis] + half;
    half_width = std::max(half_width, half);
  }
  if (half_width == 0.0) return false;
  const double scale = 1.0 / half_width;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double offset = points.coordinate(axis, travellers[i].index) - middle[axis];
      travellers[i].at[axis] = static_cast<float>(offset * scale);
    }
  }
  return true;
}

Bounds bounds_of(const PointsView& points, const Traveller* travellers, std::size_t count) {
  Bounds bounds;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = points.coordinate(axis, travellers[0].index);
    double high = low;
    for (std::size_t i = 1; i < count; ++i) {
      const double value = points.coordinate(axis, travellers[i].index);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    bounds.low[axis] = low;
    bounds.high[axis] = high;
  }
  return bounds;
}

// How many slabs along which axis: as if the longest edge was halved again and again down to the
// leaves; the halvings of the axis that comes first are done together, as far as there are units.
Cuts choose_cuts(const Part& part, const Extent& extent) {
  std::array<float, 3> width = extent.width;
  const auto widest = [&] {
    return static_cast<std::size_t>(std::max_element(width.begin(), width.end()) - width.begin());
  };
  Cuts cuts{widest(), 1, {}};
  for (std::size_t points = part.size(); points > kFanOut; points = (points + 1) / 2) {
    const std::size_t axis = widest();
    width[axis] /= 2;
    if (axis == cuts.axis) cuts.count *= 2;
  }
  const std::size_t units = part.units();
  cuts.count = std::min(cuts.count, units);
  for (std::size_t slab = 0; slab < cuts.count; ++slab) {
    cuts.at[slab] = part.begin + part.unit * (units * slab / cuts.count);
  }
  cuts.at[cuts.count] = part.end;
  return cuts;
}

// Where travellers are along an axis, in intervals of equal width.
class Intervals {
 public:
  Intervals(const Part& part, const Extent& extent, std::size_t axis)
      : axis_(axis),
        count_(std::clamp<std::size_t>(std::bit_floor(part.size()), kFewest, kMost)),
        low_(extent.low[axis]),
        factor_(static_cast<float>(count_) / extent.width[axis]) {
    std::fill_n(sizes_.begin(), count_, 0U);
    for (std::size_t i = part.begin; i < part.end; ++i) ++sizes_[of(part.from[i])];
  }

  // Distributes the travellers to stacks: one for what lies between two cuts, one for each interval
  // in which a cut falls. False, with nothing done, when such an interval holds too many. `borders`
  // becomes the intervals of the cuts, and the last one.
  bool distribute(const Part& part, const Cuts& cuts,
                  std::array<std::size_t, kFanOut + 1>& borders) {
    std::array<std::uint8_t, kMost> stack_of;
    std::array<std::size_t, 2 * kFanOut> next{};
    std::uint8_t stack = 0;
    std::size_t interval = 0;
    std::size_t before = next[0] = part.begin;
    std::size_t open = 0;  // the first interval without a stack
    borders[0] = 0;
    for (std::size_t cut = 1; cut < cuts.count; ++cut) {
      while (before + sizes_[interval] <= cuts.at[cut]) before += sizes_[interval++];
      if (sizes_[interval] > part.size() / 8) return false;
      borders[cut] = interval;
      if (interval < open) continue;  // the interval of the cut before
      std::fill(stack_of.begin() + open, stack_of.begin() + interval, stack);
      next[++stack] = before;
      stack_of[interval] = stack;
      next[++stack] = before + sizes_[interval];
      open = interval + 1;
    }
    borders[cuts.count] = count_ - 1;
    std::fill(stack_of.begin() + open, stack_of.begin() + count_, stack);
    for (std::size_t i = part.begin; i < part.end; ++i) {
      part.to[next[stack_of[of(part.from[i])]]++] = part.from[i];
    }
    return true;
  }

  // The part of an extent that lies in the intervals [first, last].
  [[nodiscard]] Extent narrowed(Extent extent, std::size_t first, std::size_t last) const {
    extent.low[axis_] = low_ + static_cast<float>(first) / factor_;
    extent.width[axis_] = static_cast<float>(last + 1 - first) / factor_;
    return extent;
  }

 private:
  static constexpr std::size_t kFewest = 64;
  static constexpr std::size_t kMost = 4096;

  [[nodiscard]] std::size_t of(const Traveller& traveller) const {
    const float interval = (traveller.at[axis_] - low_) * factor_;
    const std::size_t whole = static_cast<std::size_t>(static_cast<std::int32_t>(interval));
    return std::min(whole, count_ - 1);
  }

  std::size_t axis_;
  std::size_t count_;
  float low_;
  float factor_;
  std::array<std::uint32_t, kMost> sizes_;
};

// The same by exact coordinates.
void deal_exactly(const PointsView& points, const Part& part, const Cuts& cuts) {
  auto* const keys = reinterpret_cast<ExactKey*>(part.to);
  for (std::size_t i = part.begin; i < part.end; ++i) {
    keys[i] = {points.coordinate(cuts.axis, part.from[i].index), i};
  }
  const auto by_coordinate = [](const ExactKey& a, const ExactKey& b) {
    return a.coordinate < b.coordinate;
  };
  // The middle cut first, so that every point is passed over about log2(slabs) times.
  const auto cut_between = [&](const auto& self, std::size_t first, std::size_t last) -> void {
    if (last - first < 2) return;
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(keys + cuts.at[first], keys + cuts.at[middle], keys + cuts.at[last],
                     by_coordinate);
    self(self, first, middle);
    self(self, middle, last);
  };
  cut_between(cut_between, 0, cuts.count);
  for (std::size_t i = part.begin; i < part.end; ++i) {
    const std::size_t position = keys[i].position;
    part.to[i] = part.from[position];
  }
}

class Arranger {
 public:
  Arranger(const PointsView& points, std::uint32_t* order) : points_(points), order_(order) {}

  // Brings a part into order, down to the leaves; `keep(part)` may take over smaller ones. The
  // extent is given when it is known well enough.
  template <class Keep>
  void arrange(Part part, const Keep& keep, const Extent* known = nullptr) const {
    if (part.size() <= kFanOut) return write(part);
    if (part.size() <= part.unit) known = nullptr;
    while (part.size() <= part.unit) part.unit /= kFanOut;
    Extent extent;
    if (known != nullptr) {
      extent = *known;
    } else if (!find_extent(part, extent)) {
      return write(part);
    }
    const Cuts cuts = choose_cuts(part, extent);
    std::array<Extent, kFanOut> slabs;
    const bool are_known = distribute(part, cuts, extent, slabs);
    for (std::size_t slab = 0; slab < cuts.count; ++slab) {
      const Part next{part.to, part.from, cuts.at[slab], cuts.at[slab + 1], part.unit};
      if (!keep(next)) arrange(next, keep, are_known ? &slabs[slab] : nullptr);
    }
  }

 private:
  // False when all are at one place.
  bool find_extent(const Part& part, Extent& extent) const {
    // Below this, the floats of a frame tell too little about a part of it.
    constexpr float kNarrow = 0x1p-12F;
    Traveller* const travellers = part.from + part.begin;
    extent = measure(travellers, part.size());
    if (*std::max_element(extent.width.begin(), extent.width.end()) > kNarrow) return true;
    const Bounds bounds = bounds_of(points_, travellers, part.size());
    if (!place_in_frame(points_, travellers, part.size(), bounds)) return false;
    extent = measure(travellers, part.size());
    return true;
  }

  // Whether it is known where the slabs lie. A call of its own, so that the intervals do not stay
  // on the stack of what follows.
  [[gnu::noinline]] bool distribute(const Part& part, const Cuts& cuts, const Extent& extent,
                                    std::array<Extent, kFanOut>& slabs) const {
    Intervals intervals(part, extent, cuts.axis);
    std::array<std::size_t, kFanOut + 1> borders;
    if (!intervals.distribute(part, cuts, borders)) {
      deal_exactly(points_, part, cuts);
      return false;
    }
    for (std::size_t slab = 0; slab < cuts.count; ++slab) {
      slabs[slab] = intervals.narrowed(extent, borders[slab], borders[slab + 1]);
    }
    return true;
  }

  void write(const Part& part) const {
    for (std::size_t i = part.begin; i < part.end; ++i) order_[i] = part.from[i].index;
  }

  const PointsView& points_;
  std::uint32_t* order_;
};

}  // namespace

Buffer<std::uint32_t> point_tree_order(const PointsView& points, const Bounds& bounds,
                                       const Resources& with, Buffer<TreeLeaf>& leaves,
                                       Buffer<Point>& slots) {
  static_assert(sizeof(TreeLeaf) >= kFanOut * sizeof(Traveller));
  static_assert(sizeof(Point) >= sizeof(Traveller));
  const std::size_t size = points.size();
  auto* const travellers = reinterpret_cast<Traveller*>(leaves.data());
  auto* const others = reinterpret_cast<Traveller*>(slots.data());
  Buffer<std::uint32_t> order(with.memory, size);
  with.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      travellers[i] = {{}, static_cast<std::uint32_t>(i)};
    }
    place_in_frame(points, travellers + begin, end - begin, bounds);
  });

  const Arranger arranger(points, order.data());
  std::size_t unit = kFanOut;
  while (unit * kFanOut < size) unit *= kFanOut;
  const Part whole{travellers, others, 0, size, unit};
  const auto keep_none = [](const Part&) { return false; };
  if (with.crew.size() == 1) {
    arranger.arrange(whole, keep_none);
  } else {
    Vector<Part> children(&with.memory);
    arranger.arrange(whole, [&](const Part& part) {
      if (part.size() > part.unit) return false;
      children.push_back(part);
      return true;
    });
    std::atomic<std::size_t> next{0};
    with.crew.run([&](unsigned) {
      for (std::size_t i = next++; i < children.size(); i = next++) {
        arranger.arrange(children[i], keep_none);
      }
    });
  }
  return order;
}

}  // namespace beespace::core
