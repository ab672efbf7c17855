#include "search/closest_pair_search.hpp"

#include "base/hash.hpp"
#include "exact/exact_distance.hpp"
#include "search/pair_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

namespace beespace::search {

namespace {

constexpr std::size_t kFewPoints = 256;  // compared each with each
constexpr std::size_t kRun = 16;         // points that are drawn together
constexpr std::size_t kRunShare =
    32;  // one run of so many is drawn: a bound for some thousand pairs

// The best pair so far, compared exactly.
class Closest {
 public:
  explicit Closest(const PointsView& points) : points_(points) {}

  // first < second.
  void offer(const Pair& pair) {
    const double squared = core::squared_distance(points_[pair.first], points_[pair.second]);
    if (squared > surely_farther_) return;
    if (found_) {
      const int sign = core::compare_distances(points_[pair.first], points_[pair.second],
                                               points_[best_.first], points_[best_.second]);
      if (sign > 0 || (sign == 0 && pair > best_)) return;
    }
    best_ = pair;
    found_ = true;
    surely_farther_ = squared * (1.0 + 0x1p-49);  // both carry at most 5 * 2^-53
  }

  [[nodiscard]] Pair best() const { return best_; }

 private:
  PointsView points_;
  Pair best_;
  bool found_ = false;
  double surely_farther_ = std::numeric_limits<double>::infinity();
};

// The lowest pair of points at the same place; there must be one.
Pair lowest_duplicates(const PointsView& points, core::Memory& memory) {
  constexpr PointId kEmpty = std::numeric_limits<PointId>::max();
  const std::size_t slots = std::bit_ceil(points.size() * 2);
  core::Vector<PointId> first_at(slots, kEmpty, &memory);
  Pair lowest{kEmpty, kEmpty};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    std::size_t slot = core::hash_place(p) & (slots - 1);
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
core::Vector<Point> random_sample(const PointsView& points, core::Memory& memory) {
  constexpr std::size_t kStretch = kRun * kRunShare;
  core::Vector<Point> sample(&memory);
  sample.reserve(points.size() / kRunShare + kRun);
  for (std::size_t begin = 0; begin + kRun <= points.size(); begin += kStretch) {
    const std::size_t room = std::min(kStretch, points.size() - begin) - kRun + 1;
    const std::size_t first = begin + core::mix(begin + points.size()) % room;
    for (std::size_t i = first; i < first + kRun; ++i) sample.push_back(points[i]);
  }
  return sample;
}

// The distance of some pair of a sample: an upper bound that few pairs of all are within.
double bound_from_sample(const SearchDomain& domain, const core::Resources& with,
                         const TuningOverrides& tuning) {
  const core::Vector<Point> sample = random_sample(domain.original_points(), with.memory);
  const Pair near = find_closest_pair(
      SearchDomain::of(std::span<const Point>(sample), domain.original_bounds(), with), with,
      tuning);
  // Rounded up, so that the pair itself is within the bound.
  return std::sqrt(core::squared_distance(sample[near.first], sample[near.second])) *
         (1.0 + 0x1p-40);
}

}  // namespace

Pair find_closest_pair(const SearchDomain& domain, const core::Resources& with,
                       const TuningOverrides& tuning) {
  const PointsView& points = domain.original_points();
  Closest closest(points);
  if (points.size() <= kFewPoints) {
    const auto size = static_cast<PointId>(points.size());
    for (PointId i = 0; i < size; ++i) {
      for (PointId j = i + 1; j < size; ++j) closest.offer({i, j});
    }
    return closest.best();
  }
  const double bound_m = bound_from_sample(domain, with, tuning);
  if (bound_m == 0.0) return lowest_duplicates(points, with.memory);
  const auto offer = [&](std::span<const Pair> pairs) {
    for (const Pair& pair : pairs) closest.offer(pair);
    return true;
  };
  visit_pairs(domain, {.threshold_m = bound_m, .inclusive = true}, with, tuning, std::cref(offer));
  return closest.best();
}

}  // namespace beespace::search
