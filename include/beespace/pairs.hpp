/// @file
/// @brief Which pairs of points are closer to each other than the threshold?
///
/// Compared as real numbers, as in at_risk.hpp. The number of results is not capped: in a crowd
/// there are many more pairs than points. Bound them with PairOptions::max_results, or visit them
/// without keeping them.
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

/// @brief Two points.
struct Pair {
  PointId first = 0;   ///< In pairs of one set, below `second`; between two sets, of the first set.
  PointId second = 0;  ///< The other point.

  friend constexpr auto operator<=>(const Pair&, const Pair&) = default;  // NOLINT(*-use-nullptr)
};

/// @brief Finds all pairs of points closer than the threshold.
///
/// Complexity: some tens of nanoseconds a point, and up to some tens a pair, the fewer the more
/// neighbours points have. Memory: 40 bytes a point, and 16 a pair, or 8 where points have a
/// hundred neighbours. Thread safety: no state is kept.
///
/// @param points The positions in metres; read in place, not kept.
/// @param options The threshold and how to search.
/// @return Each pair once with first < second, in ascending order; or an error as find_at_risk, and
///   ErrorCode::kTooManyResults when there are more than PairOptions::max_results.
BEESPACE_API Result<std::vector<Pair>> find_pairs(const PointsView& points,
                                                  const PairOptions& options);

/// @brief Finds all pairs of a point of one set and a point of another that are closer than the
/// threshold.
///
/// Complexity and thread safety: as find_pairs.
///
/// @param points The positions in metres of Pair::first.
/// @param others The positions in metres of Pair::second.
/// @param options The threshold and how to search.
/// @return The pairs in ascending order; or an error as find_pairs.
BEESPACE_API Result<std::vector<Pair>> find_pairs_between(const PointsView& points,
                                                          const PointsView& others,
                                                          const PairOptions& options);

/// @brief Sees a batch of pairs; returns whether to go on. Must not throw.
using PairVisitor = std::function<bool(std::span<const Pair>)>;

/// @brief The largest batch that visit_pairs shows to a visitor.
inline constexpr std::size_t kMostPairsAtOnce = 4096;
/// @brief Shows all pairs of points closer than the threshold to a visitor, in batches of at most
/// #kMostPairsAtOnce.
///
/// Holds no more pairs than a batch for each thread. Thread safety: no state is kept.
///
/// @param points The positions in metres; read in place, not kept.
/// @param options The threshold and how to search; there is no limit to their number.
/// @param visit Sees each pair once with first < second, in no particular order. It is called by
/// one
///   thread at a time, not always the same, and must not throw. The span is valid during the call.
/// @return True when all pairs were seen, false when `visit` ended it; or an error as find_at_risk.
BEESPACE_API Result<bool> visit_pairs(const PointsView& points, const SearchOptions& options,
                                      const PairVisitor& visit);

/// @brief Computes the distance of each pair.
/// @param points The positions in metres.
/// @param pairs The pairs; their ids must be valid (unchecked).
/// @return The distances in metres, as beespace::distance says.
BEESPACE_API std::vector<double> pair_distances(const PointsView& points,
                                                std::span<const Pair> pairs);
/// @brief Computes the distance of each pair of points of two sets.
/// @param points The positions in metres of Pair::first.
/// @param others The positions in metres of Pair::second.
/// @param pairs The pairs; their ids must be valid (unchecked).
/// @return The distances in metres, as beespace::distance says.
BEESPACE_API std::vector<double> pair_distances_between(const PointsView& points,
                                                        const PointsView& others,
                                                        std::span<const Pair> pairs);

}  // namespace beespace
