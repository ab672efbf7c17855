#include "grid/density.hpp"

#include "base/hash.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace beespace::core {

namespace {

constexpr std::size_t kMostDrawn = 4096;
constexpr std::size_t kFewestDrawn = 512;
constexpr std::size_t kPointsADraw = 64;

std::size_t drawn_of(std::size_t points) {
  return std::min(points, std::clamp(points / kPointsADraw, kFewestDrawn, kMostDrawn));
}

// One at a random place of every stretch of the input: no rhythm of the input's order can hide a
// crowd.
Point drawn_point(const PointsView& points, std::size_t i, std::size_t drawn) {
  const std::size_t begin = points.size() * i / drawn;
  const std::size_t end = points.size() * (i + 1) / drawn;
  return points[begin + mix(i + 1) % (end - begin)];
}

std::uint64_t cell_of(const Point& point, double cells_a_m) {
  std::uint64_t cell = 0;
  for (const double coordinate : {point.x, point.y, point.z}) {
    // Any bit pattern that is the same for the same cell will do; + 0.0 makes -0 plain 0.
    cell = mix(cell + std::bit_cast<std::uint64_t>(std::floor(coordinate * cells_a_m) + 0.0));
  }
  return cell;
}

}  // namespace

DensitySample::DensitySample(const PointsView& points, Memory& memory)
    : population_(points.size()),
      size_(drawn_of(points.size())),
      slots_(std::bit_ceil(2 * size_ + 1)),
      points_(memory, size_),
      table_(memory, slots_) {
  for (std::size_t i = 0; i < size_; ++i) points_[i] = drawn_point(points, i, size_);
}

double DensitySample::expected_neighbors(double cell_m) const {
  if (size_ < 2) return 0.0;
  const double pairs = fill_table(1.0 / cell_m);
  const auto drawn = static_cast<double>(size_);
  return pairs / (drawn * (drawn - 1.0)) * static_cast<double>(population_ - 1);
}

// Counts the sample's points in cells; returns how many pairs share one, each from both sides.
double DensitySample::fill_table(double cells_a_m) const {
  std::fill_n(table_.data(), slots_, Slot{0, 0});
  double pairs = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    const std::uint64_t cell = cell_of(points_[i], cells_a_m);
    Slot& slot = table_[slot_of(cell)];
    pairs += 2.0 * slot.points;
    slot = {cell, slot.points + 1};
  }
  return pairs;
}

// The slot of a cell, or the free one that it would take.
std::size_t DensitySample::slot_of(std::uint64_t cell) const {
  std::size_t slot = cell & (slots_ - 1);
  while (table_[slot].points != 0 && table_[slot].cell != cell) slot = (slot + 1) & (slots_ - 1);
  return slot;
}

std::uint32_t DensitySample::sampled_around(const Point& point, double cells_a_m) const {
  return table_[slot_of(cell_of(point, cells_a_m))].points;
}

double DensitySample::share_apart(const PointsView* asked, double least_m, double most_m) const {
  constexpr double kSome = 6.0;  // so that chance leaves hardly any point of an even swarm alone
  if (size_ < 2) return 0.0;
  double cell_m = least_m;
  double pairs = fill_table(1.0 / cell_m);
  for (; pairs < kSome * static_cast<double>(size_) && cell_m < most_m; cell_m *= 2.0) {
    pairs = fill_table(0.5 / cell_m);
  }
  const std::size_t drawn = asked == nullptr ? size_ : drawn_of(asked->size());
  if (drawn == 0) return 0.0;
  std::size_t apart = 0;
  for (std::size_t i = 0; i < drawn; ++i) {
    if (asked == nullptr) {
      apart += sampled_around(points_[i], 1.0 / cell_m) == 1 ? 1U : 0U;
    } else {
      apart += sampled_around(drawn_point(*asked, i, drawn), 1.0 / cell_m) == 0 ? 1U : 0U;
    }
  }
  return static_cast<double>(apart) / static_cast<double>(drawn);
}

double DensitySample::side_for(double wanted, const Bounds& bounds) const {
  double widest = 0.0;
  double log_volume = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double extent = bounds.high[axis] - bounds.low[axis];
    widest = std::max(widest, extent);
  }
  if (size_ < 2 || widest == 0.0) return widest;
  // The average over the box; an axis that is much shorter than the side does not count.
  const auto all = static_cast<double>(population_);
  double side = widest;
  for (int round = 0; round < 3; ++round) {
    unsigned axes = 0;
    log_volume = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double extent = bounds.high[axis] - bounds.low[axis];
      if (round > 0 && extent <= side) continue;
      if (extent <= 0.0) continue;
      ++axes;
      log_volume += std::log(extent);
    }
    if (axes == 0) break;
    side = std::exp((log_volume + std::log(wanted / all)) / axes);
  }
  // As a share of the widest extent: below it, only duplicates share cells, even in a clump with an
  // outlier. And cell numbers must be valid in the whole coordinate domain.
  constexpr double kSmallest = 0x1p-200;
  const double smallest = std::max(widest * kSmallest, 0x1p-500);
  side = std::clamp(side, smallest, widest);
  double met = expected_neighbors(side);
  if (met > 0.5 * wanted && met < 2.0 * wanted) return side;
  if (met <= wanted) {
    while (side < widest && met < 0.5 * wanted)
      met = expected_neighbors(side = std::min(2.0 * side, widest));
    return side;
  }
  const double twins = expected_neighbors(smallest);
  while (side > smallest && met - twins > 2.0 * wanted)
    met = expected_neighbors(side = std::max(0.5 * side, smallest));
  return side;
}

}  // namespace beespace::core
