// The plain at-risk search that the orders of cells are compared in: sort points by the key of
// their cell, find the occupied cells ahead of each, compare, mark.
#pragma once

#include "base/buffer.hpp"
#include "base/hash.hpp"
#include "bench/cell_orders.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::bench {

using core::Buffer;
using core::Memory;

struct Range {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

struct Record {
  std::uint64_t key;
  PointId id;
};

// Points in the order of their cells, and the occupied cells in the same order.
struct Grid {
  std::size_t size = 0;
  std::size_t cells = 0;
  Buffer<Point> points;
  Buffer<PointId> ids;
  Buffer<Place> places;
  Buffer<std::uint64_t> keys;
  Buffer<std::uint32_t> begins;  // one more than cells

  [[nodiscard]] Range range(std::size_t cell) const { return {begins[cell], begins[cell + 1]}; }
};

// Least digit first, digits of at most eleven bits.
inline void radix_sort(Buffer<Record>& records, std::size_t size, unsigned key_bits,
                       Memory& memory) {
  Buffer<Record> other(memory, size);
  const unsigned passes = (key_bits + 10) / 11;
  const unsigned digit_bits = (key_bits + passes - 1) / passes;
  const std::uint64_t mask = (std::uint64_t{1} << digit_bits) - 1;
  for (unsigned pass = 0; pass < passes; ++pass) {
    std::array<std::uint32_t, 2048> ends{};
    const unsigned shift = pass * digit_bits;
    for (std::size_t i = 0; i < size; ++i) ++ends[records[i].key >> shift & mask];
    std::uint32_t begin = 0;
    for (std::uint32_t& end : ends) begin += std::exchange(end, begin);
    for (std::size_t i = 0; i < size; ++i) {
      other[ends[records[i].key >> shift & mask]++] = records[i];
    }
    std::swap(records, other);
  }
}

inline Grid gather(const std::vector<Point>& points, const Buffer<Record>& records,
                   const Cells& cells, Memory& memory) {
  const std::size_t size = points.size();
  Grid grid{size,
            0,
            Buffer<Point>(memory, size),
            Buffer<PointId>(memory, size),
            Buffer<Place>(memory, size),
            Buffer<std::uint64_t>(memory, size),
            Buffer<std::uint32_t>(memory, size + 1)};
  for (std::size_t i = 0; i < size; ++i) {
    grid.ids[i] = records[i].id;
    grid.points[i] = points[records[i].id];
    if (i > 0 && records[i].key == records[i - 1].key) continue;
    grid.keys[grid.cells] = records[i].key;
    grid.places[grid.cells] = cells.place(grid.points[i]);
    grid.begins[grid.cells++] = static_cast<std::uint32_t>(i);
  }
  grid.begins[grid.cells] = static_cast<std::uint32_t>(size);
  return grid;
}

// Ways to find the occupied cells ahead of a cell. `ahead` passes their points to `visit`.

// A hash table of the occupied cells, the same for every order.
template <class Order>
class ByHash {
 public:
  static constexpr const char* kName = "hash";

  ByHash(const Grid& grid, const Cells& cells, const Order&, Memory& memory)
      : grid_(grid),
        steps_(steps_ahead(cells.bits)),
        mask_(std::bit_ceil(2 * grid.cells) - 1),
        slots_(memory, mask_ + 1) {
    std::fill_n(slots_.data(), mask_ + 1, Slot{0, {}});
    for (std::size_t c = 0; c < grid.cells; ++c)
      *find(grid.places[c]) = {grid.places[c], grid.range(c)};
  }

  template <class Visit>
  void ahead(std::size_t cell, const Visit& visit) {
    for (const Place step : steps_) {
      const Slot* slot = find(grid_.places[cell] + step);
      if (slot->place != 0) visit(slot->range);
    }
  }

 private:
  struct Slot {
    Place place;  // 0 where empty: cells count from one
    Range range;
  };

  // Where `place` is or would be.
  Slot* find(Place place) {
    std::size_t at = core::mix(place) & mask_;
    while (slots_[at].place != 0 && slots_[at].place != place) at = (at + 1) & mask_;
    return &slots_[at];
  }

  const Grid& grid_;
  std::array<Place, 13> steps_;
  std::size_t mask_;
  Buffer<Slot> slots_;
};

// The sorted keys, and where those with the same high bits begin; a binary search among these.
template <class Order>
class ByKey {
 public:
  static constexpr const char* kName = "keys";

  ByKey(const Grid& grid, const Cells& cells, const Order& order, Memory& memory)
      : grid_(grid),
        order_(order),
        prefixes_(std::min(std::bit_ceil(grid.cells), std::size_t{1} << (3 * cells.bits))),
        shift_(3 * cells.bits - static_cast<unsigned>(std::bit_width(prefixes_ - 1))),
        firsts_(memory, prefixes_ + 1) {
    std::size_t cell = 0;
    for (std::size_t prefix = 0; prefix <= prefixes_; ++prefix) {
      while (cell < grid.cells && grid.keys[cell] >> shift_ < prefix) ++cell;
      firsts_[prefix] = static_cast<std::uint32_t>(cell);
    }
  }

  template <class Visit>
  void ahead(std::size_t cell, const Visit& visit) {
    for (const std::uint64_t key : order_.keys_ahead(grid_.keys[cell], grid_.places[cell])) {
      const std::uint64_t* const keys = grid_.keys.data();
      const std::uint64_t* const end = keys + firsts_[(key >> shift_) + 1];
      const std::uint64_t* const found = std::lower_bound(keys + firsts_[key >> shift_], end, key);
      if (found != end && *found == key) visit(grid_.range(static_cast<std::size_t>(found - keys)));
    }
  }

 private:
  const Grid& grid_;
  const Order& order_;
  std::size_t prefixes_;
  unsigned shift_;
  Buffer<std::uint32_t> firsts_;
};

// Lists made beforehand, by a hash table: the search then only compares, so that orders differ only
// by where the points are in memory.
template <class Order>
class ByList {
 public:
  static constexpr const char* kName = "lists";

  ByList(const Grid& grid, const Cells& cells, const Order& order, Memory& memory)
      : begins_(memory, grid.cells + 1), ranges_(memory, kAhead.size() * grid.cells) {
    ByHash<Order> table(grid, cells, order, memory);
    std::size_t end = 0;
    for (std::size_t cell = 0; cell < grid.cells; ++cell) {
      begins_[cell] = end;
      table.ahead(cell, [&](Range range) { ranges_[end++] = range; });
    }
    begins_[grid.cells] = end;
  }

  template <class Visit>
  void ahead(std::size_t cell, const Visit& visit) {
    for (std::size_t i = begins_[cell]; i < begins_[cell + 1]; ++i) visit(ranges_[i]);
  }

 private:
  Buffer<std::size_t> begins_;
  Buffer<Range> ranges_;
};

// A window of three cells along each of the four rows ahead; only rows stand in such an order.
template <class Order>
class ByWindows {
 public:
  static constexpr const char* kName = "windows";

  ByWindows(const Grid& grid, const Cells& cells, const Order&, Memory&)
      : grid_(grid),
        rows_{Place{1} << cells.bits, (Place{1} << 2 * cells.bits) - (Place{1} << cells.bits),
              Place{1} << 2 * cells.bits, (Place{1} << 2 * cells.bits) + (Place{1} << cells.bits)} {
  }

  template <class Visit>
  void ahead(std::size_t cell, const Visit& visit) {
    const Place place = grid_.places[cell];
    if (cell + 1 < grid_.cells && grid_.places[cell + 1] == place + 1) visit(grid_.range(cell + 1));
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      std::size_t& first = firsts_[row];
      std::size_t& end = ends_[row];
      const Place middle = place + rows_[row];
      while (first < grid_.cells && grid_.places[first] < middle - 1) ++first;
      while (end < grid_.cells && grid_.places[end] <= middle + 1) ++end;
      if (first < end) visit(Range{grid_.begins[first], grid_.begins[end]});
    }
  }

 private:
  const Grid& grid_;
  std::array<Place, 4> rows_;
  std::array<std::size_t, 4> firsts_{};
  std::array<std::size_t, 4> ends_{};
};

// Both points of every pair that is too close.
class Marks {
 public:
  Marks(const Grid& grid, double threshold_m, Memory& memory)
      : points_(grid.points.data()), limit_(threshold_m * threshold_m), marks_(memory, grid.size) {
    std::fill_n(marks_.data(), grid.size, std::uint8_t{0});
  }

  void within(Range own) {
    for (std::uint32_t i = own.begin; i < own.end; ++i) compare(i, {i + 1, own.end});
  }
  void across(Range own, Range others) {
    for (std::uint32_t i = own.begin; i < own.end; ++i) compare(i, others);
  }
  // The ids of those marked, ascending.
  void ids(const Grid& grid, Memory& memory, std::vector<PointId>& ids) const {
    Buffer<std::uint8_t> by_id(memory, grid.size);
    for (std::size_t i = 0; i < grid.size; ++i) by_id[grid.ids[i]] = marks_[i];
    ids.clear();
    for (std::size_t id = 0; id < grid.size; ++id) {
      if (by_id[id] != 0) ids.push_back(static_cast<PointId>(id));
    }
  }

 private:
  void compare(std::uint32_t i, Range others) {
    const Point p = points_[i];
    std::uint8_t any = 0;
    for (std::uint32_t j = others.begin; j < others.end; ++j) {
      const double x = points_[j].x - p.x;
      const double y = points_[j].y - p.y;
      const double z = points_[j].z - p.z;
      const auto near = static_cast<std::uint8_t>(x * x + y * y + z * z < limit_);
      any |= near;
      marks_[j] |= near;
    }
    marks_[i] |= any;
  }

  const Point* points_;
  double limit_;
  Buffer<std::uint8_t> marks_;
};

// A cache that evicts the least recently used line of a set of `ways` lines.
class SimulatedCache {
 public:
  SimulatedCache(std::size_t sets, std::size_t ways) : ways_(ways), lines_(sets * ways, 0) {}

  void touch(std::uint64_t line) {
    const std::size_t sets = lines_.size() / ways_;
    const auto set = lines_.begin() + static_cast<std::ptrdiff_t>(line % sets * ways_);
    const auto end = set + static_cast<std::ptrdiff_t>(ways_);
    const auto found = std::find(set, end, line + 1);
    if (found == end) ++misses_;
    std::move_backward(set, found == end ? end - 1 : found, found == end ? end : found + 1);
    *set = line + 1;
  }
  [[nodiscard]] std::uint64_t misses() const { return misses_; }

 private:
  std::size_t ways_;
  std::vector<std::uint64_t> lines_;  // one more than the line, latest first; 0 where empty
  std::uint64_t misses_ = 0;
};

// The caches of a search: 48 KiB in 12 ways, 2 MiB in 16, lines of 64 bytes.
struct Looks {
  std::uint64_t comparisons = 0;
  SimulatedCache l1{64, 12};
  SimulatedCache l2{2048, 16};

  void within(Range own) {
    const std::uint64_t size = own.end - own.begin;
    comparisons += size * (size - 1) / 2;
    read(own);
  }
  void across(Range own, Range others) {
    comparisons += std::uint64_t{own.end - own.begin} * (others.end - others.begin);
    read(others);
  }
  void read(Range range) {
    const std::uint64_t last = (range.end * sizeof(Point) - 1) / 64;
    for (std::uint64_t line = range.begin * sizeof(Point) / 64; line <= last; ++line) {
      l1.touch(line);
      l2.touch(line);
    }
  }
};

template <class Locator, class Visitor>
void sweep(const Grid& grid, Locator& locator, Visitor& visitor) {
  for (std::size_t cell = 0; cell < grid.cells; ++cell) {
    const Range own = grid.range(cell);
    visitor.within(own);
    locator.ahead(cell, [&](Range others) { visitor.across(own, others); });
  }
}

}  // namespace beespace::bench
