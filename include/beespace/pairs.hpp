// Which pairs of points are closer to each other than the threshold?
//
// Compared as real numbers, as in at_risk.hpp. Nothing is capped: in a crowd there are many more
// pairs than points. Bound them with SearchOptions::max_results, or visit them without keeping
// them.
#pragma once

#include <beespace/export.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <compare>
#include <functional>
#include <span>
#include <vector>

namespace beespace {

struct Pair {
  PointId first = 0;
  PointId second = 0;

  friend constexpr auto operator<=>(const Pair&, const Pair&) = default;  // NOLINT(*-use-nullptr)
};

// All pairs closer than the threshold, each once with first < second, in ascending order.
//
// Cost: some tens of nanoseconds a point, and ten to thirty a pair. Memory: 40 bytes a point, and
// 16 a pair. Errors: as find_at_risk; kTooManyResults when there are more than options.max_results.
BEESPACE_API Result<std::vector<Pair>> find_pairs(const PointsView& points,
                                                  const SearchOptions& options);

// All pairs of one of `points` (first) and one of `others` (second), in ascending order.
BEESPACE_API Result<std::vector<Pair>> find_pairs_between(const PointsView& points,
                                                          const PointsView& others,
                                                          const SearchOptions& options);

// Sees pairs by the batch; returns whether to go on.
using PairVisitor = std::function<bool(std::span<const Pair>)>;

// Shows all pairs to `visit`, each once with first < second, in no particular order, in batches of
// at most kMostPairsAtOnce. Holds no more pairs than a batch for each thread. `visit` is called by
// one thread at a time, not always the same, and must not throw. The value is true when all pairs
// were seen, false when `visit` ended it. Errors: as find_at_risk; max_results does not apply.
inline constexpr std::size_t kMostPairsAtOnce = 4096;
BEESPACE_API Result<bool> visit_pairs(const PointsView& points, const SearchOptions& options,
                                      const PairVisitor& visit);

// How far apart the points of each pair are, in metres, as distance() says. Ids must be valid.
BEESPACE_API std::vector<double> pair_distances(const PointsView& points,
                                                std::span<const Pair> pairs);
BEESPACE_API std::vector<double> pair_distances_between(const PointsView& points,
                                                        const PointsView& others,
                                                        std::span<const Pair> pairs);

}  // namespace beespace
