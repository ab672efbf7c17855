// The reference: every pair is looked at, every distance is compared exactly.
//
// Quadratic, plain, single-threaded, and right by inspection. All fast searches are tested
// against these; use them to check beespace, or anything else, on small inputs.
// Same meaning, errors and order as the functions of the same name in namespace beespace.
#pragma once

#include <beespace/at_risk.hpp>
#include <beespace/conflict_groups.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/nearest.hpp>
#include <beespace/neighbors.hpp>
#include <beespace/pairs.hpp>
#include <beespace/predict_conflicts.hpp>

namespace beespace::brute_force {

BEESPACE_API Result<std::vector<PointId>> find_at_risk(const PointsView& points,
                                                       const SearchOptions& options);
BEESPACE_API Result<std::vector<PointId>> find_at_risk_between(const PointsView& points,
                                                               const PointsView& others,
                                                               const SearchOptions& options);

BEESPACE_API Result<std::vector<Pair>> find_pairs(const PointsView& points,
                                                  const SearchOptions& options);
BEESPACE_API Result<std::vector<Pair>> find_pairs_between(const PointsView& points,
                                                          const PointsView& others,
                                                          const SearchOptions& options);

BEESPACE_API Result<IdRows> find_neighbors(const PointsView& points, const SearchOptions& options);
BEESPACE_API Result<IdRows> find_neighbors_between(const PointsView& points,
                                                   const PointsView& others,
                                                   const SearchOptions& options);

BEESPACE_API Result<std::vector<std::uint32_t>> count_neighbors(const PointsView& points,
                                                                const SearchOptions& options);
BEESPACE_API Result<std::vector<std::uint32_t>> count_neighbors_between(
    const PointsView& points, const PointsView& others, const SearchOptions& options);

BEESPACE_API Result<IdRows> find_conflict_groups(const PointsView& points,
                                                 const SearchOptions& options);

BEESPACE_API Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points);
BEESPACE_API Result<std::optional<ClosestPair>> find_closest_pair_between(const PointsView& points,
                                                                          const PointsView& others);

BEESPACE_API Result<std::vector<Nearest>> find_nearest(const PointsView& points);
BEESPACE_API Result<std::vector<Nearest>> find_nearest_within(const PointsView& points,
                                                              const SearchOptions& options);
BEESPACE_API Result<std::vector<Nearest>> find_nearest_between(const PointsView& points,
                                                               const PointsView& others);
BEESPACE_API Result<std::vector<Nearest>> find_nearest_within_between(const PointsView& points,
                                                                      const PointsView& others,
                                                                      const SearchOptions& options);

BEESPACE_API Result<std::vector<Conflict>> predict_conflicts(const MoversView& movers,
                                                             const PredictOptions& options);

BEESPACE_API Result<RecordedConflicts> find_conflicts(std::span<const Track> tracks,
                                                      const ConflictOptions& options);

}  // namespace beespace::brute_force
