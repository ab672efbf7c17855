#include "grid/closest_pair.hpp"

#include "base/bounds.hpp"
#include "base/hash.hpp"
#include "exact/exact_distance.hpp"
#include "grid/lattice.hpp"
#include "grid/near_pairs.hpp"
#include "grid/occupancy_filter.hpp"
#include "grid/sorted_grid.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace beespace::core {

namespace {

constexpr std::size_t kFewPoints = 256;     // compared each with each
constexpr std::size_t kRun = 16;            // points that are drawn together
constexpr std::size_t kRunShare = 8;        // one run of so many is drawn
constexpr double kSieveCellInBounds = 8.0;  // wide cells: few of their points are near a face

// The best pair so far, compared exactly.
class Closest {
 public:
  explicit Closest(const PointsView& points) : points_(&points) {}

  void offer(PointId a, PointId b) {
    const double squared = squared_distance((*points_)[a], (*points_)[b]);
    if (squared > surely_farther_) return;
    const IdPair pair = a < b ? IdPair{a, b} : IdPair{b, a};
    if (found_) {
      const int sign = compare_distances((*points_)[pair.first], (*points_)[pair.second],
                                         (*points_)[best_.first], (*points_)[best_.second]);
      const bool lower =
          pair.first != best_.first ? pair.first < best_.first : pair.second < best_.second;
      if (sign > 0 || (sign == 0 && !lower)) return;
    }
    best_ = pair;
    found_ = true;
    surely_farther_ = squared * (1.0 + 0x1p-49);  // both carry at most 5 * 2^-53
  }

  [[nodiscard]] bool has_found() const { return found_; }
  [[nodiscard]] IdPair best() const { return best_; }

 private:
  const PointsView* points_;
  IdPair best_{0, 0};
  bool found_ = false;
  double surely_farther_ = std::numeric_limits<double>::infinity();
};

// The lowest pair of points at the same place; there must be one.
IdPair lowest_duplicates(const PointsView& points, Memory& memory) {
  constexpr PointId kEmpty = std::numeric_limits<PointId>::max();
  const std::size_t slots = std::bit_ceil(points.size() * 2);
  Vector<PointId> first_at(slots, kEmpty, &memory);
  IdPair lowest{kEmpty, kEmpty};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    std::size_t slot = hash_place(p) & (slots - 1);
    while (first_at[slot] != kEmpty && points[first_at[slot]] != p) slot = (slot + 1) & (slots - 1);
    const auto id = static_cast<PointId>(i);
    if (first_at[slot] == kEmpty) {
      first_at[slot] = id;
    } else if (first_at[slot] < lowest.first) {
      lowest = {first_at[slot], id};
    }
  }
  return lowest;
}

// Short runs of neighbours in memory: as good as single points for the bound, since a run hides at
// most the pairs within its own stretch of the input, and six times cheaper to read.
Vector<Point> random_sample(const PointsView& points, Memory& memory) {
  constexpr std::size_t kStretch = kRun * kRunShare;
  Vector<Point> sample(&memory);
  sample.reserve(points.size() / kRunShare + kRun);
  for (std::size_t begin = 0; begin + kRun <= points.size(); begin += kStretch) {
    const std::size_t room = std::min(kStretch, points.size() - begin) - kRun + 1;
    const std::size_t first = begin + mix(begin + points.size()) % room;
    for (std::size_t i = first; i < first + kRun; ++i) sample.push_back(points[i]);
  }
  return sample;
}

// The closest pair among points of which two are at most `bound` apart.
IdPair closest_within(const PointsView& points, const Bounds& bounds, double bound,
                      const Resources& with) {
  const Lattice lattice(std::span(&points, 1), bounds, bound, with.memory);
  const SortedGrid grid = sort_into_grid({points}, lattice, 0, with);
  const SquaredLimits limits(bound, grid.units_per_m);
  Vector<Closest> found(with.crew.size(), Closest(points), &with.memory);
  with.crew.split(grid.rows(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    Closest closest(points);
    for_each_near_pair(
        grid, begin, end, limits.surely_far,
        [&](std::uint32_t i, std::uint32_t j, float) { closest.offer(grid.id[i], grid.id[j]); });
    found[worker] = closest;
  });
  Closest closest(points);
  for (const Closest& one : found) {
    if (one.has_found()) closest.offer(one.best().first, one.best().second);
  }
  return closest.best();
}

}  // namespace

IdPair closest_pair(const PointsView& points, const Bounds& bounds, const Resources& with) {
  if (points.size() <= kFewPoints) {
    Closest closest(points);
    const auto size = static_cast<PointId>(points.size());
    for (PointId i = 0; i < size; ++i) {
      for (PointId j = i + 1; j < size; ++j) closest.offer(i, j);
    }
    return closest.best();
  }

  const Vector<Point> sample = random_sample(points, with.memory);
  const IdPair near = closest_pair(std::span<const Point>(sample), bounds, with);
  // Rounded up, so that the pair itself is within the bound.
  const double bound =
      std::sqrt(squared_distance(sample[near.first], sample[near.second])) * (1.0 + 0x1p-40);
  if (bound == 0.0) return lowest_duplicates(points, with.memory);

  const Lattice lattice(std::span(&points, 1), bounds, kSieveCellInBounds * bound, with.memory);
  const Vector<PointId> left = occupancy_filter(points, lattice, bound, with);
  Vector<Point> few(left.size(), &with.memory);
  for (std::size_t i = 0; i < left.size(); ++i) few[i] = points[left[i]];
  // Ids ascend, so the lowest pair of the few is the lowest pair of all.
  const IdPair pair = closest_within(std::span<const Point>(few), bounds, bound, with);
  return {left[pair.first], left[pair.second]};
}

}  // namespace beespace::core
