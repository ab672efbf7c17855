// Cells of space and four orders to keep them in: rows, Morton's curve, Hilbert's curve, none.
#pragma once

#include <beespace/point.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace beespace::bench {

// The number of a cell: x in the low bits, then y, then z, `bits` each. Cells count from one and
// end before the last number, so that cells beside one another differ by a constant.
using Place = std::uint64_t;

struct Cells {
  std::array<double, 3> low{};
  double cells_per_m = 0.0;
  unsigned bits = 0;

  Cells(const std::vector<Point>& points, double threshold_m) {
    // Wider than the threshold by far more than what rounding can move a point.
    cells_per_m = 1.0 / (threshold_m * (1.0 + 0x1p-20));
    low = {points[0].x, points[0].y, points[0].z};
    std::array<double, 3> high = low;
    for (const Point& p : points) {
      const std::array<double, 3> at = {p.x, p.y, p.z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
    }
    std::uint64_t last = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) last = std::max(last, cell(axis, high[axis]));
    bits = static_cast<unsigned>(std::bit_width(last + 1));
    if (bits > 21) std::abort();
  }

  [[nodiscard]] std::uint64_t cell(std::size_t axis, double value) const {
    return static_cast<std::uint64_t>((value - low[axis]) * cells_per_m) + 1;
  }
  [[nodiscard]] Place place(const Point& p) const {
    return cell(0, p.x) | cell(1, p.y) << bits | cell(2, p.z) << (2 * bits);
  }
};

// The thirteen cells ahead of a cell, of the twenty-six around it; the others are behind.
struct Step {
  int x, y, z;
};
inline constexpr std::array<Step, 13> kAhead = {{{1, 0, 0},
                                                 {-1, 1, 0},
                                                 {0, 1, 0},
                                                 {1, 1, 0},
                                                 {-1, -1, 1},
                                                 {0, -1, 1},
                                                 {1, -1, 1},
                                                 {-1, 0, 1},
                                                 {0, 0, 1},
                                                 {1, 0, 1},
                                                 {-1, 1, 1},
                                                 {0, 1, 1},
                                                 {1, 1, 1}}};

// What to add to a place.
inline std::array<Place, 13> steps_ahead(unsigned bits) {
  std::array<Place, 13> steps{};
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const auto [x, y, z] = kAhead[k];
    steps[k] = static_cast<Place>(x) + (static_cast<Place>(y) << bits) +
               (static_cast<Place>(z) << (2 * bits));
  }
  return steps;
}

// The orders. `key` is where a cell stands; `keys_ahead` where those ahead of it do, as the order
// can best tell from the cell's key or place.
using KeysAhead = std::array<std::uint64_t, 13>;

struct RowOrder {
  static constexpr const char* kName = "rows";

  explicit RowOrder(unsigned bits) : steps(steps_ahead(bits)) {}

  [[nodiscard]] std::uint64_t key(Place place) const { return place; }
  [[nodiscard]] KeysAhead keys_ahead(std::uint64_t key, Place) const {
    KeysAhead keys{};
    for (std::size_t k = 0; k < keys.size(); ++k) keys[k] = key + steps[k];
    return keys;
  }

  std::array<Place, 13> steps;
};

// Two zeros before every bit.
constexpr std::uint64_t spread(std::uint64_t value) {
  value = (value | value << 32) & 0x001F00000000FFFFU;
  value = (value | value << 16) & 0x001F0000FF0000FFU;
  value = (value | value << 8) & 0x100F00F00F00F00FU;
  value = (value | value << 4) & 0x10C30C30C30C30C3U;
  return (value | value << 2) & 0x1249249249249249U;
}

struct MortonOrder {
  static constexpr const char* kName = "morton";

  explicit MortonOrder(unsigned place_bits) : bits(place_bits) {}

  [[nodiscard]] std::uint64_t key(Place place) const {
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    return spread(place & mask) | spread(place >> bits & mask) << 1 |
           spread(place >> (2 * bits)) << 2;
  }
  // A carry runs through the bits of the other axes where those are set.
  [[nodiscard]] KeysAhead keys_ahead(std::uint64_t key, Place) const {
    std::array<std::array<std::uint64_t, 3>, 3> part{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint64_t own = spread(0x1FFFFF) << axis;
      part[axis] = {((key & own) - 1) & own, key & own, ((key | ~own) + 1) & own};
    }
    KeysAhead keys{};
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const auto [x, y, z] = kAhead[k];
      keys[k] = part[0][static_cast<std::size_t>(x + 1)] |
                part[1][static_cast<std::size_t>(y + 1)] | part[2][static_cast<std::size_t>(z + 1)];
    }
    return keys;
  }

  unsigned bits;
};

// Skilling, "Programming the Hilbert curve" (2004): turn and mirror from the coarsest bit down,
// then the Gray code; the bits of the three results interleaved are the place on the curve. His
// conditions are masks here, as no branch could be foreseen.
struct HilbertOrder {
  static constexpr const char* kName = "hilbert";

  explicit HilbertOrder(unsigned place_bits) : bits(place_bits), steps(steps_ahead(place_bits)) {}

  [[nodiscard]] std::uint64_t key(Place place) const {
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    std::uint64_t a = place & mask;
    std::uint64_t b = place >> bits & mask;
    std::uint64_t c = place >> (2 * bits);
    for (unsigned bit = bits - 1; bit > 0; --bit) {
      const std::uint64_t below = (std::uint64_t{1} << bit) - 1;
      a ^= below & (0 - (a >> bit & 1));
      turn(a, b, bit, below);
      turn(a, c, bit, below);
    }
    b ^= a;
    c ^= b;
    std::uint64_t flips = 0;
    for (unsigned bit = bits - 1; bit > 0; --bit) {
      flips ^= ((std::uint64_t{1} << bit) - 1) & (0 - (c >> bit & 1));
    }
    return spread(a ^ flips) << 2 | spread(b ^ flips) << 1 | spread(c ^ flips);
  }

  [[nodiscard]] KeysAhead keys_ahead(std::uint64_t, Place place) const {
    KeysAhead keys{};
    for (std::size_t k = 0; k < keys.size(); ++k) keys[k] = key(place + steps[k]);
    return keys;
  }

  static void turn(std::uint64_t& first, std::uint64_t& other, unsigned bit, std::uint64_t below) {
    const std::uint64_t set = 0 - (other >> bit & 1);
    const std::uint64_t swapped = (first ^ other) & below & ~set;
    first ^= swapped | (below & set);
    other ^= swapped;
  }

  unsigned bits;
  std::array<Place, 13> steps;
};

// Cells next to each other stand anywhere: no locality at all. One to one on 3 * bits bits.
struct RandomOrder {
  static constexpr const char* kName = "random";

  explicit RandomOrder(unsigned place_bits)
      : bits(3 * place_bits), steps(steps_ahead(place_bits)) {}

  [[nodiscard]] std::uint64_t key(Place place) const {
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    std::uint64_t value = place * 0x9E3779B97F4A7C15U & mask;
    value ^= value >> (bits / 2);
    value = value * 0xC2B2AE3D27D4EB4FU & mask;
    return value ^ value >> (bits / 2);
  }
  [[nodiscard]] KeysAhead keys_ahead(std::uint64_t, Place place) const {
    KeysAhead keys{};
    for (std::size_t k = 0; k < keys.size(); ++k) keys[k] = key(place + steps[k]);
    return keys;
  }

  unsigned bits;
  std::array<Place, 13> steps;
};

}  // namespace beespace::bench
