#include "analysis/snapshot/worst_pairs.hpp"

#include <beespace/nearest.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace beespace::analysis {
namespace {

struct Apart {
  double distance_m;
  Pair pair;

  friend bool operator<(const Apart& a, const Apart& b) {
    return std::tie(a.distance_m, a.pair) < std::tie(b.distance_m, b.pair);
  }
};

Result<std::uint64_t> count_pairs(Engine& engine, const PointsView& places,
                                  const SearchOptions& options) {
  std::vector<std::uint32_t> counts;
  if (Status counted = engine.count_neighbors(places, options, counts); !counted) {
    return counted.error();
  }
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}) / 2;
}

// A threshold below that of the options, with so many pairs that they can be sorted; nothing where
// none was found, as where very many are equally close.
std::optional<double> smaller_threshold(Engine& engine, const PointsView& places,
                                        SearchOptions options, std::uint64_t count) {
  constexpr int kMostTries = 40;
  double too_small_m = 0.0;
  double too_large_m = options.threshold_m;
  // In space the pairs grow with the cube of the threshold.
  double next_m = too_large_m * std::cbrt(3.0 * kWorstPairs / static_cast<double>(count));
  for (int k = 0; k < kMostTries && next_m > too_small_m && next_m < too_large_m; ++k) {
    options.threshold_m = next_m;
    const auto found = count_pairs(engine, places, options);
    if (!found) return std::nullopt;
    if (*found >= kWorstPairs && *found <= kAllPairs) return next_m;
    (*found < kWorstPairs ? too_small_m : too_large_m) = next_m;
    next_m = 0.5 * (too_small_m + too_large_m);
  }
  return std::nullopt;
}

// Looks at all and keeps the closest.
Result<std::vector<Apart>> closest_of_all(Engine& engine, const PointsView& places,
                                          const PointsView& points, const SearchOptions& options) {
  std::vector<Apart> closest;  // a heap, the farthest first
  const auto seen = engine.visit_pairs(places, options, [&](std::span<const Pair> pairs) {
    for (const Pair& pair : pairs) {
      const Apart apart{distance(points[pair.first], points[pair.second]), pair};
      if (closest.size() == kWorstPairs) {
        if (!(apart < closest.front())) continue;
        std::pop_heap(closest.begin(), closest.end());
        closest.pop_back();
      }
      closest.push_back(apart);
      std::push_heap(closest.begin(), closest.end());
    }
    return true;
  });
  if (!seen) return seen.error();
  return closest;
}

Result<std::vector<Apart>> found_pairs(Engine& engine, const PointsView& places,
                                       const PointsView& points, const SearchOptions& options) {
  std::vector<Pair> pairs;
  if (Status found = engine.find_pairs(places, options, pairs); !found) return found.error();
  const std::vector<double> distances_m = pair_distances(points, pairs);
  std::vector<Apart> all;
  all.reserve(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) all.push_back({distances_m[i], pairs[i]});
  return all;
}

Result<std::vector<Apart>> pairs_to_show(Engine& engine, const PointsView& places,
                                         const PointsView& points, SearchOptions options,
                                         std::uint64_t count) {
  if (count <= kAllPairs) return found_pairs(engine, places, points, options);
  if (!options.vertical_m) {
    if (const auto smaller_m = smaller_threshold(engine, places, options, count)) {
      options.threshold_m = *smaller_m;
      return found_pairs(engine, places, points, options);
    }
  }
  return closest_of_all(engine, places, points, options);
}

}  // namespace

Result<WorstPairs> worst_pairs(Engine& engine, const PointsView& places, const PointsView& points,
                               const SearchOptions& options) {
  const auto count = count_pairs(engine, places, options);
  if (!count) return count.error();
  auto pairs = pairs_to_show(engine, places, points, options, *count);
  if (!pairs) return std::move(pairs).error();
  std::sort(pairs->begin(), pairs->end());
  if (*count > kAllPairs) pairs->resize(std::min<std::size_t>(pairs->size(), kWorstPairs));
  WorstPairs worst;
  worst.count = *count;
  for (const Apart& apart : *pairs) {
    worst.pairs.push_back(apart.pair);
    worst.distances_m.push_back(apart.distance_m);
  }
  return worst;
}

}  // namespace beespace::analysis
