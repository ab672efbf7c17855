/// @file
/// @brief The reference: each pair is looked at, each distance is compared exactly.
///
/// Quadratic, plain, single-threaded, and right by inspection. All fast searches are tested against
/// these functions; use them to check beespace, or any other program, on small inputs. Meaning,
/// errors and order are those of the functions of the same name in namespace beespace.
#pragma once

#include <beespace/at_risk.hpp>
#include <beespace/conflict_groups.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/nearest.hpp>
#include <beespace/neighbors.hpp>
#include <beespace/pairs.hpp>
#include <beespace/predict_conflicts.hpp>

/// @brief The reference: each pair is looked at, each distance is compared exactly. Quadratic,
/// single-threaded, without state.
namespace beespace::brute_force {

/// @brief As beespace::find_at_risk, in quadratic time.
/// @param points The positions in metres.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::find_at_risk.
BEESPACE_API Result<std::vector<PointId>> find_at_risk(const PointsView& points,
                                                       const SearchOptions& options);

/// @brief As beespace::find_at_risk_between, in quadratic time.
/// @param points The positions in metres of which ids are returned.
/// @param others The positions in metres of the other set.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::find_at_risk_between.
BEESPACE_API Result<std::vector<PointId>> find_at_risk_between(const PointsView& points,
                                                               const PointsView& others,
                                                               const SearchOptions& options);

/// @brief As beespace::find_pairs, in quadratic time.
/// @param points The positions in metres.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::find_pairs.
BEESPACE_API Result<std::vector<Pair>> find_pairs(const PointsView& points,
                                                  const PairOptions& options);

/// @brief As beespace::find_pairs_between, in quadratic time.
/// @param points The positions in metres of the first of each pair.
/// @param others The positions in metres of the second of each pair.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::find_pairs_between.
BEESPACE_API Result<std::vector<Pair>> find_pairs_between(const PointsView& points,
                                                          const PointsView& others,
                                                          const PairOptions& options);

/// @brief As beespace::find_neighbors, in quadratic time.
/// @param points The positions in metres.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::find_neighbors.
BEESPACE_API Result<IdRows> find_neighbors(const PointsView& points, const PairOptions& options);

/// @brief As beespace::find_neighbors_between, in quadratic time.
/// @param points The positions in metres, each of which has a row.
/// @param others The positions in metres of the other set.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::find_neighbors_between.
BEESPACE_API Result<IdRows> find_neighbors_between(const PointsView& points,
                                                   const PointsView& others,
                                                   const PairOptions& options);

/// @brief As beespace::count_neighbors, in quadratic time.
/// @param points The positions in metres.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::count_neighbors.
BEESPACE_API Result<std::vector<std::uint32_t>> count_neighbors(const PointsView& points,
                                                                const SearchOptions& options);

/// @brief As beespace::count_neighbors_between, in quadratic time.
/// @param points The positions in metres, each of which has a count.
/// @param others The positions in metres of the other set.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::count_neighbors_between.
BEESPACE_API Result<std::vector<std::uint32_t>> count_neighbors_between(
    const PointsView& points, const PointsView& others, const SearchOptions& options);

/// @brief As beespace::find_conflict_groups, in quadratic time.
/// @param points The positions in metres.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::find_conflict_groups.
BEESPACE_API Result<IdRows> find_conflict_groups(const PointsView& points,
                                                 const SearchOptions& options);

/// @brief As beespace::find_closest_pair, in quadratic time.
/// @param points The positions in metres.
/// @return As beespace::find_closest_pair.
BEESPACE_API Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points);

/// @brief As beespace::find_closest_pair_between, in quadratic time.
/// @param points The positions in metres of the first of the pair.
/// @param others The positions in metres of the second of the pair.
/// @return As beespace::find_closest_pair_between.
BEESPACE_API Result<std::optional<ClosestPair>> find_closest_pair_between(const PointsView& points,
                                                                          const PointsView& others);

/// @brief As beespace::find_nearest, in quadratic time.
/// @param points The positions in metres.
/// @return As beespace::find_nearest.
BEESPACE_API Result<std::vector<Nearest>> find_nearest(const PointsView& points);

/// @brief As beespace::find_k_nearest, in quadratic time and more: each point sorts all others.
/// @param points The positions in metres.
/// @param k How many neighbours to find for each point.
/// @return As beespace::find_k_nearest.
BEESPACE_API Result<NearestRows> find_k_nearest(const PointsView& points, std::size_t k);

/// @brief As beespace::find_nearest_within, in quadratic time.
/// @param points The positions in metres.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::find_nearest_within.
BEESPACE_API Result<std::vector<Nearest>> find_nearest_within(const PointsView& points,
                                                              const SearchOptions& options);

/// @brief As beespace::find_nearest_between, in quadratic time.
/// @param points The positions in metres, each of which has an entry.
/// @param others The positions in metres of the other set.
/// @return As beespace::find_nearest_between.
BEESPACE_API Result<std::vector<Nearest>> find_nearest_between(const PointsView& points,
                                                               const PointsView& others);

/// @brief As beespace::find_nearest_within_between, in quadratic time.
/// @param points The positions in metres, each of which has an entry.
/// @param others The positions in metres of the other set.
/// @param options The threshold; threads and stop tokens are ignored.
/// @return As beespace::find_nearest_within_between.
BEESPACE_API Result<std::vector<Nearest>> find_nearest_within_between(const PointsView& points,
                                                                      const PointsView& others,
                                                                      const SearchOptions& options);

/// @brief As beespace::predict_conflicts, in quadratic time.
/// @param movers The agents, in metres and metres per second.
/// @param options The threshold and the horizon; threads and stop tokens are ignored.
/// @return As beespace::predict_conflicts.
BEESPACE_API Result<std::vector<Conflict>> predict_conflicts(const MoversView& movers,
                                                             const PredictOptions& options);

/// @brief As beespace::find_conflicts, in quadratic time.
/// @param tracks The recorded tracks, in metres and seconds.
/// @param options The threshold and the gaps; threads and stop tokens are ignored.
/// @return As beespace::find_conflicts.
BEESPACE_API Result<RecordedConflicts> find_conflicts(std::span<const Track> tracks,
                                                      const ConflictOptions& options);

}  // namespace beespace::brute_force
