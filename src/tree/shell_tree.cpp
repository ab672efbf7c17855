#include "tree/shell_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace beespace::core {

namespace {

using Vector3 = std::array<double, 3>;

Vector3 seen_from(const Point& centre, const Point& point) {
  return {point.x - centre.x, point.y - centre.y, point.z - centre.z};
}

double product(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// How far along the curve of Hilbert a place on a square is, of 2^kSteps a side.
std::uint64_t along_hilbert(std::uint32_t x, std::uint32_t y) {
  constexpr unsigned kSteps = 27;
  constexpr std::uint32_t kLast = (1U << kSteps) - 1;
  std::uint64_t along = 0;
  for (unsigned step = kSteps; step-- > 0;) {
    const std::uint32_t right = x >> step & 1U;
    const std::uint32_t up = y >> step & 1U;
    along = along << 2 | ((3U * right) ^ up);
    if (up == 0) {  // this quarter's curve is turned
      if (right == 1) {
        x = kLast - x;
        y = kLast - y;
      }
      std::swap(x, y);
    }
  }
  return along;
}

// The place of a direction in the order: the face of a cube, and along a curve on it.
std::uint64_t key_of(const Vector3& at) {
  constexpr double kHalf = 0x1p+26;
  constexpr std::uint32_t kLast = (1U << 27) - 1;
  std::size_t face = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (std::abs(at[axis]) > std::abs(at[face])) face = axis;
  }
  const double length = std::abs(at[face]);
  if (length == 0.0) return 0;
  const auto step = [&](double across) {
    return std::min(kLast, static_cast<std::uint32_t>((across / length + 1.0) * kHalf));
  };
  const std::uint64_t number = 2 * face + (at[face] < 0.0 ? 1 : 0);
  return number << 60 | along_hilbert(step(at[(face + 1) % 3]), step(at[(face + 2) % 3]));
}

}  // namespace

ShellTree::ShellTree(const PointsView& points, const Point& centre, const Resources& with)
    : size_(points.size()),
      centre_(centre),
      points_(with.memory, size_),
      leaves_(with.memory, leaf_count()),
      ids_(with.memory, size_) {
  sort(points, with);
  while (nodes(top_) > 1) ++top_;
  std::size_t all = 0;
  for (unsigned level = 0; level <= top_; ++level) {
    first_of_level_[level] = all;
    all += nodes(level);
  }
  rows_ = Buffer<ShellRow>(with.memory, all);
  for (unsigned level = 0; level <= top_; ++level) {
    with.crew.split(nodes(level), [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t node = begin; node < end; ++node) {
        fill(rows_[first_of_level_[level] + node], level, node);
      }
    });
  }
}

void ShellTree::sort(const PointsView& points, const Resources& with) {
  struct Entry {
    std::uint64_t key;
    PointId id;
  };
  Buffer<Entry> entries(with.memory, size_);
  with.crew.split(size_, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      entries[i] = {key_of(seen_from(centre_, points[i])), static_cast<PointId>(i)};
    }
  });
  std::sort(entries.data(), entries.data() + size_, [](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key < b.key : a.id < b.id;
  });
  with.crew.split(size_, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      ids_[slot] = entries[slot].id;
      points_[slot] = points[ids_[slot]];
    }
  });
  with.crew.split(leaf_count(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t slot = begin * kFanOut; slot < end * kFanOut; ++slot) {
      constexpr double kNoPlace = std::numeric_limits<double>::infinity();
      const Point p = slot < size_ ? points_[slot] : Point{kNoPlace, kNoPlace, kNoPlace};
      double* const at = leaves_[slot / kFanOut].at + slot % kFanOut;
      at[0] = p.x;
      at[kFanOut] = p.y;
      at[2 * kFanOut] = p.z;
    }
  });
}

void ShellTree::fill(ShellRow& row, unsigned level, std::size_t node) const {
  const std::size_t points_a_child = kFanOut << (4 * level);
  for (std::size_t lane = 0; lane < kFanOut; ++lane) {
    const std::size_t begin = std::min((node * kFanOut + lane) * points_a_child, size_);
    fill_child(row, lane, begin, std::min(begin + points_a_child, size_));
  }
}

void ShellTree::fill_child(ShellRow& row, std::size_t lane, std::size_t begin,
                           std::size_t end) const {
  constexpr double kSlack = 0x1p-44;
  Vector3 towards{};
  for (std::size_t slot = begin; slot < end; ++slot) {
    const Vector3 at = seen_from(centre_, points_[slot]);
    for (std::size_t axis = 0; axis < 3; ++axis) towards[axis] += at[axis];
  }
  const double length = std::sqrt(product(towards, towards));
  for (double& coordinate : towards) coordinate = length > 0.0 ? coordinate / length : 0.0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  double low = 0.0;
  double high = 0.0;
  double aside = 0.0;
  for (std::size_t slot = begin; slot < end; ++slot) {
    const Vector3 at = seen_from(centre_, points_[slot]);
    const double squared = product(at, at);
    const double along = product(at, towards);
    Vector3 across = at;
    for (std::size_t axis = 0; axis < 3; ++axis) across[axis] -= along * towards[axis];
    least = std::min(least, squared);
    most = std::max(most, squared);
    low = slot == begin ? along : std::min(low, along);
    high = slot == begin ? along : std::max(high, along);
    aside = std::max(aside, product(across, across));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) row.towards[axis][lane] = towards[axis];
  row.least[lane] = least - kSlack * most;
  row.low[lane] = low;
  row.high[lane] = high;
  row.aside[lane] = std::sqrt(aside);
}

}  // namespace beespace::core
