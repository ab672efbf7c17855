#include "cylinders/cylinder_order.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <limits>

namespace beespace::core {

namespace {

constexpr unsigned kMostHalvings = 16;

struct Extent {
  std::array<double, Upright::kAxes> low;
  std::array<double, Upright::kAxes> high;

  static Extent none() {
    Extent extent{};
    extent.low.fill(std::numeric_limits<double>::infinity());
    extent.high.fill(-std::numeric_limits<double>::infinity());
    return extent;
  }
  void add(const Upright& place) {
    for (std::size_t axis = 0; axis < Upright::kAxes; ++axis) {
      low[axis] = std::min(low[axis], place.at[axis]);
      high[axis] = std::max(high[axis], place.at[axis]);
    }
  }
  [[nodiscard]] bool is_one_place() const { return low == high; }
};

// How a box is cut: the cell of a place on each axis, and the key that these make up.
class Cells {
 public:
  // `tables` is working memory.
  Cells(const Extent& extent, const CylinderSize& size, unsigned halvings,
        Vector<std::uint32_t>& tables)
      : low_(extent.low), tables_(tables) {
    std::array<double, Upright::kAxes> width;  // in thresholds
    for (std::size_t axis = 0; axis < Upright::kAxes; ++axis) {
      width[axis] = (extent.high[axis] - extent.low[axis]) / size.along(axis);
    }
    std::array<std::uint8_t, kMostHalvings> axis_of;
    std::array<unsigned, Upright::kAxes> bits{};
    for (unsigned k = 0; k < halvings; ++k) {
      const auto widest =
          static_cast<std::size_t>(std::max_element(width.begin(), width.end()) - width.begin());
      axis_of[k] = static_cast<std::uint8_t>(widest);
      ++bits[widest];
      width[widest] /= 2;
    }
    std::size_t used = 0;
    for (std::size_t axis = 0; axis < Upright::kAxes; ++axis) {
      const std::uint32_t cells = std::uint32_t{1} << bits[axis];
      last_[axis] = static_cast<double>(cells - 1);
      const double whole = extent.high[axis] - extent.low[axis];
      cells_per_m_[axis] = whole > 0.0 ? static_cast<double>(cells) / whole : 0.0;
      table_[axis] = used;
      used += cells;
    }
    tables_.resize(used);
    for (std::size_t axis = 0; axis < Upright::kAxes; ++axis)
      fill_table(axis, bits[axis], axis_of, halvings);
  }

  [[nodiscard]] std::uint32_t key(const Upright& place) const {
    std::uint32_t key = 0;
    for (std::size_t axis = 0; axis < Upright::kAxes; ++axis) {
      const double cell = std::min((place.at[axis] - low_[axis]) * cells_per_m_[axis], last_[axis]);
      key |= tables_[table_[axis] + static_cast<std::size_t>(static_cast<std::int32_t>(cell))];
    }
    return key;
  }

 private:
  // The bits of an axis's cell at their places in the key: the first halving is the highest bit.
  void fill_table(std::size_t axis, unsigned bits,
                  const std::array<std::uint8_t, kMostHalvings>& axis_of, unsigned halvings) {
    std::uint32_t* const table = tables_.data() + table_[axis];
    table[0] = 0;
    unsigned bit = bits;  // of the cell
    for (unsigned k = 0; k < halvings; ++k) {
      if (axis_of[k] != axis) continue;
      --bit;
      table[std::size_t{1} << bit] = std::uint32_t{1} << (halvings - 1 - k);
    }
    for (std::uint32_t cell = 3; cell < std::uint32_t{1} << bits; ++cell) {
      table[cell] = table[cell & (cell - 1)] | table[cell & -cell];
    }
  }

  std::array<double, Upright::kAxes> low_;
  std::array<double, Upright::kAxes> cells_per_m_{};
  std::array<double, Upright::kAxes> last_{};
  std::array<std::size_t, Upright::kAxes> table_{};
  Vector<std::uint32_t>& tables_;
};

// So many halvings that a cell holds a few on average.
unsigned halvings_of(std::size_t points, std::size_t few) {
  const auto cells = static_cast<unsigned>(std::bit_width(2 * points / (few + 1)));
  return std::clamp(cells, 1U, kMostHalvings);
}

// Orders parts of one array with working memory of its own.
class Orderer {
 public:
  Orderer(const UprightPoints& points, const CylinderSize& size, std::size_t few, Memory& memory)
      : points_(points),
        size_(size),
        few_(few),
        tables_(&memory),
        keys_(&memory),
        spare_(&memory),
        begins_(&memory) {}

  void order(std::uint32_t* ids, std::size_t count) {
    if (count <= few_) return;
    Extent extent = Extent::none();
    for (std::size_t i = 0; i < count; ++i) extent.add(points_[ids[i]]);
    if (extent.is_one_place()) return;
    const unsigned halvings = halvings_of(count, few_);
    const Cells cells(extent, size_, halvings, tables_);
    if (keys_.size() < count) {
      keys_.resize(count);
      spare_.resize(count);
    }
    for (std::size_t i = 0; i < count; ++i) keys_[i] = cells.key(points_[ids[i]]);
    std::copy_n(ids, count, spare_.begin());
    const std::size_t base = begins_.size();
    const std::size_t ncells = std::size_t{1} << halvings;
    begins_.resize(base + ncells + 1);
    distribute(spare_.data(), keys_.data(), count, ncells, ids, begins_.data() + base);
    for (std::size_t cell = 0; cell < ncells; ++cell) {
      const std::uint32_t begin = begins_[base + cell];
      order(ids + begin, begins_[base + cell + 1] - begin);
    }
    begins_.resize(base);
  }

  // Distributes ids by their keys (a counting sort); begins[k] is where those of key k begin.
  static void distribute(const std::uint32_t* ids, const std::uint32_t* keys, std::size_t count,
                         std::size_t cells, std::uint32_t* to, std::uint32_t* begins) {
    std::fill_n(begins, cells + 1, 0U);
    for (std::size_t i = 0; i < count; ++i) ++begins[keys[i] + 1];
    for (std::size_t k = 1; k <= cells; ++k) begins[k] += begins[k - 1];
    for (std::size_t i = 0; i < count; ++i) to[begins[keys[i]]++] = ids[i];
    // Each now stands where the one behind it began.
    std::copy_backward(begins, begins + cells, begins + cells + 1);
    begins[0] = 0;
  }

 private:
  const UprightPoints& points_;
  const CylinderSize& size_;
  std::size_t few_;
  Vector<std::uint32_t> tables_;
  Vector<std::uint32_t> keys_;
  Vector<std::uint32_t> spare_;
  Vector<std::uint32_t> begins_;  // a stack
};

Extent extent_of(const UprightPoints& points, const Resources& with) {
  Vector<Extent> parts(with.crew.size(), Extent::none(), &with.memory);
  with.crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    Extent extent = Extent::none();
    for (std::size_t i = begin; i < end; ++i) extent.add(points[i]);
    parts[worker] = extent;
  });
  Extent whole = Extent::none();
  for (const Extent& part : parts) {
    for (std::size_t axis = 0; axis < Upright::kAxes; ++axis) {
      whole.low[axis] = std::min(whole.low[axis], part.low[axis]);
      whole.high[axis] = std::max(whole.high[axis], part.high[axis]);
    }
  }
  return whole;
}

}  // namespace

Buffer<std::uint32_t> cylinder_order(const UprightPoints& points, const CylinderSize& size,
                                     std::size_t few, const Resources& with) {
  const std::size_t count = points.size();
  Buffer<std::uint32_t> order(with.memory, count);
  Buffer<std::uint32_t> ids(with.memory, count);
  for (std::size_t i = 0; i < count; ++i) order[i] = ids[i] = static_cast<std::uint32_t>(i);
  if (count <= few) return order;
  const Extent extent = extent_of(points, with);
  if (extent.is_one_place()) return order;
  const unsigned halvings = halvings_of(count, few);
  Vector<std::uint32_t> tables(&with.memory);
  const Cells cells(extent, size, halvings, tables);
  Buffer<std::uint32_t> keys(with.memory, count);
  with.crew.split(count, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) keys[i] = cells.key(points[i]);
  });
  Vector<std::uint32_t> begins((std::size_t{1} << halvings) + 1, &with.memory);
  Orderer::distribute(ids.data(), keys.data(), count, begins.size() - 1, order.data(),
                      begins.data());
  constexpr std::size_t kAtOnce = 64;  // cells
  std::atomic<std::size_t> next{0};
  with.crew.run([&](unsigned worker) {
    Orderer orderer(points, size, few, with.memory.of(worker));
    for (;;) {
      const std::size_t first = next.fetch_add(kAtOnce);
      if (first + 1 >= begins.size()) return;
      const std::size_t last = std::min(first + kAtOnce, begins.size() - 1);
      for (std::size_t cell = first; cell < last; ++cell) {
        orderer.order(order.data() + begins[cell], begins[cell + 1] - begins[cell]);
      }
    }
  });
  return order;
}

}  // namespace beespace::core
