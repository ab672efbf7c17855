// A block of points in a loop: coordinates in one short array an axis, which the compiler can
// vectorise over, for any layout of the caller.
#pragma once

#include <beespace/points_view.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace beespace::core {

// All points of a view, or some of them.
struct Selection {
  const PointsView& points;
  std::optional<std::span<const PointId>> ids = {};  // absent: all

  [[nodiscard]] std::size_t size() const { return ids ? ids->size() : points.size(); }
  [[nodiscard]] PointId id(std::size_t i) const {
    return ids ? (*ids)[i] : static_cast<PointId>(i);
  }
};

// Points that lie one behind the other in memory.
struct Interleaved {
  const double* xyz;                 // three coordinates a point
  std::array<std::size_t, 3> place;  // which of the three is on axis 0, 1 and 2
};

// Prefetches the `count` points behind those; a prefetch beyond the end is harmless.
inline void prefetch_behind(const double* xyz, std::size_t count) {
  const auto* const first = reinterpret_cast<const std::byte*>(xyz);
  const std::size_t bytes = count * sizeof(Point);
  for (std::size_t at = bytes; at < 2 * bytes; at += 64) __builtin_prefetch(first + at);
}

inline std::optional<Interleaved> interleaved(const PointsView& points) {
  if (points.holds_floats()) return std::nullopt;
  std::array<const double*, 3> axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    axes[axis] = static_cast<const double*>(points.axes()[axis]);
  }
  for (const std::ptrdiff_t stride : points.stride_bytes()) {
    if (stride != sizeof(Point)) return std::nullopt;
  }
  const double* const first = std::min({axes[0], axes[1], axes[2]}, std::less<>());
  Interleaved found{first, {}};
  std::array<bool, 3> taken{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // As numbers: they may point into arrays that have nothing to do with each other.
    const std::uintptr_t bytes =
        reinterpret_cast<std::uintptr_t>(axes[axis]) - reinterpret_cast<std::uintptr_t>(first);
    if (bytes > 2 * sizeof(double)) return std::nullopt;
    found.place[axis] = bytes / sizeof(double);
    taken[found.place[axis]] = true;
  }
  if (!taken[1] || !taken[2]) return std::nullopt;
  return found;
}

class PointBlock {
 public:
  static constexpr std::size_t kSize = 256;  // 6 KiB: stays in the L1 cache

  void load(const Selection& selected, std::size_t begin, std::size_t count) {
    if (!selected.ids) return load(selected.points, begin, count);
    for (std::size_t i = 0; i < count; ++i) {
      const Point p = selected.points[(*selected.ids)[begin + i]];
      values_[0][i] = p.x;
      values_[1][i] = p.y;
      values_[2][i] = p.z;
    }
  }
  // Loads the points [begin, begin + count), count <= kSize.
  void load(const PointsView& points, std::size_t begin, std::size_t count) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto* from = static_cast<const std::byte*>(points.axes()[axis]);
      const std::ptrdiff_t stride = points.stride_bytes()[axis];
      from += static_cast<std::ptrdiff_t>(begin) * stride;
      if (axis == 0) prefetch(from, stride, count);
      if (points.holds_floats()) {
        copy<float>(from, stride, count, values_[axis].data());
      } else {
        copy<double>(from, stride, count, values_[axis].data());
      }
    }
  }

  [[nodiscard]] const double* axis(std::size_t axis) const { return values_[axis].data(); }

 private:
  // Prefetches the next block while this one is processed; a prefetch beyond the end is harmless.
  static void prefetch(const std::byte* from, std::ptrdiff_t stride, std::size_t count) {
    constexpr std::size_t kPointsALine = 64 / sizeof(Point);
    for (std::size_t i = count; i < 2 * count; i += kPointsALine) {
      __builtin_prefetch(from + static_cast<std::ptrdiff_t>(i) * stride);
    }
  }

  template <class Number>
  static void copy(const std::byte* from, std::ptrdiff_t stride, std::size_t count, double* to) {
    // The common stride as a constant, so that the compiler can read whole vectors.
    constexpr auto kInterleaved = static_cast<std::ptrdiff_t>(3 * sizeof(Number));
    if (stride == kInterleaved) {
      copy_strided<Number>(from, kInterleaved, count, to);
    } else {
      copy_strided<Number>(from, stride, count, to);
    }
  }

  template <class Number>
  [[gnu::always_inline]] static void copy_strided(const std::byte* from, std::ptrdiff_t stride,
                                                  std::size_t count, double* to) {
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = static_cast<double>(
          *reinterpret_cast<const Number*>(from + static_cast<std::ptrdiff_t>(i) * stride));
    }
  }

  alignas(64) std::array<std::array<double, kSize>, 3> values_;
};

// Calls visit(begin, count) for [begin, end) in blocks.
template <class Visit>
void for_each_block(std::size_t begin, std::size_t end, Visit&& visit) {
  for (; begin < end; begin += PointBlock::kSize) {
    visit(begin, end - begin < PointBlock::kSize ? end - begin : PointBlock::kSize);
  }
}

}  // namespace beespace::core
