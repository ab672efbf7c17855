/// @file
/// @brief The searches of beespace for repeated questions: a swarm frame after frame.
///
/// An Engine keeps its working memory and its threads between calls, and writes answers into the
/// caller's containers. After two similar frames a call allocates nothing; a frame that is much
/// fuller or emptier may be searched in another way, and allocate again. The answers are those of
/// the free functions of the same name.
#pragma once

#include <beespace/closest_approach.hpp>
#include <beespace/columns.hpp>
#include <beespace/conflict.hpp>
#include <beespace/crew.hpp>
#include <beespace/export.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/lifetimebound.hpp>
#include <beespace/mover.hpp>
#include <beespace/nearest.hpp>
#include <beespace/pairs.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace beespace {

/// @brief The searches with working memory and threads that are kept between calls.
///
/// Ownership: an Engine owns its memory and threads; a Crew that is given to it must outlive it.
/// Views and options are read during a call and not kept.
///
/// Thread safety: none; use one Engine per thread (they may share a ThreadCrew).
///
/// Errors: those of the free functions of the same name. The answer is then empty.
///
/// A moved-from Engine can only be destroyed or assigned to.
class BEESPACE_API Engine {
 public:
  /// @brief Works with threads of its own, as many as SearchOptions::threads says at each call.
  Engine();
  /// @brief Works with the threads of `crew`, all of which work on every call:
  /// SearchOptions::threads is ignored.
  /// @param crew The threads; must outlive the Engine.
  explicit Engine(Crew& crew BEESPACE_LIFETIMEBOUND);
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  /// @brief Takes over memory and threads.
  Engine(Engine&&) noexcept;
  /// @brief Takes over memory and threads.
  /// @return This.
  Engine& operator=(Engine&&) noexcept;
  /// @brief Gives back memory and threads.
  ~Engine();

  /// @brief As beespace::find_at_risk.
  /// @param points The positions in metres.
  /// @param options The threshold and how to search.
  /// @param[out] at_risk The ids of the points at risk; overwritten.
  /// @return Success, or an error of beespace::find_at_risk.
  Status find_at_risk(const PointsView& points, const SearchOptions& options,
                      std::vector<PointId>& at_risk);
  /// @brief As beespace::find_at_risk_between.
  /// @param points The positions in metres of which ids are returned.
  /// @param others The positions in metres of the other set.
  /// @param options The threshold and how to search.
  /// @param[out] at_risk The ids of those `points` that are at risk; overwritten.
  /// @return Success, or an error of beespace::find_at_risk_between.
  Status find_at_risk_between(const PointsView& points, const PointsView& others,
                              const SearchOptions& options, std::vector<PointId>& at_risk);

  /// @brief As beespace::find_pairs.
  /// @param points The positions in metres.
  /// @param options The threshold and how to search.
  /// @param[out] pairs The pairs; overwritten.
  /// @return Success, or an error of beespace::find_pairs.
  Status find_pairs(const PointsView& points, const PairOptions& options, std::vector<Pair>& pairs);
  /// @brief As beespace::find_pairs_between.
  /// @param points The positions in metres of the first of each pair.
  /// @param others The positions in metres of the second of each pair.
  /// @param options The threshold and how to search.
  /// @param[out] pairs The pairs; overwritten.
  /// @return Success, or an error of beespace::find_pairs_between.
  Status find_pairs_between(const PointsView& points, const PointsView& others,
                            const PairOptions& options, std::vector<Pair>& pairs);
  /// @brief As beespace::find_pairs, in columns of the caller's.
  /// @param points The positions in metres.
  /// @param options The threshold and how to search.
  /// @param room Gives the memory for the answer, which is undefined where there is an error.
  /// @return Success, or an error of beespace::find_pairs.
  Status find_pairs(const PointsView& points, const PairOptions& options, const PairRoom& room);
  /// @brief As beespace::find_pairs_between, in columns of the caller's.
  /// @param points The positions in metres of the first of each pair.
  /// @param others The positions in metres of the second of each pair.
  /// @param options The threshold and how to search.
  /// @param room Gives the memory for the answer, which is undefined where there is an error.
  /// @return Success, or an error of beespace::find_pairs_between.
  Status find_pairs_between(const PointsView& points, const PointsView& others,
                            const PairOptions& options, const PairRoom& room);
  /// @brief As beespace::visit_pairs.
  /// @param points The positions in metres.
  /// @param options The threshold and how to search.
  /// @param visit Called with batches of pairs, by one thread at a time; returns whether to go on.
  /// @return True when all pairs were seen, false when `visit` ended it; or an error of
  ///   beespace::visit_pairs.
  Result<bool> visit_pairs(const PointsView& points, const SearchOptions& options,
                           const PairVisitor& visit);

  /// @brief As beespace::find_neighbors.
  /// @param points The positions in metres.
  /// @param options The threshold and how to search.
  /// @param[out] neighbors A row of ids for each point; overwritten.
  /// @return Success, or an error of beespace::find_neighbors.
  Status find_neighbors(const PointsView& points, const PairOptions& options, IdRows& neighbors);
  /// @brief As beespace::find_neighbors_between.
  /// @param points The positions in metres, each of which has a row.
  /// @param others The positions in metres of the other set.
  /// @param options The threshold and how to search.
  /// @param[out] neighbors A row of ids of `others` for each of `points`; overwritten.
  /// @return Success, or an error of beespace::find_neighbors_between.
  Status find_neighbors_between(const PointsView& points, const PointsView& others,
                                const PairOptions& options, IdRows& neighbors);
  /// @brief As beespace::find_neighbors, in columns of the caller's.
  /// @param points The positions in metres.
  /// @param options The threshold and how to search.
  /// @param room Gives the memory for the answer, which is undefined where there is an error.
  /// @return Success, or an error of beespace::find_neighbors.
  Status find_neighbors(const PointsView& points, const PairOptions& options, const RowRoom& room);
  /// @brief As beespace::find_neighbors_between, in columns of the caller's.
  /// @param points The positions in metres, each of which has a row.
  /// @param others The positions in metres of the other set.
  /// @param options The threshold and how to search.
  /// @param room Gives the memory for the answer, which is undefined where there is an error.
  /// @return Success, or an error of beespace::find_neighbors_between.
  Status find_neighbors_between(const PointsView& points, const PointsView& others,
                                const PairOptions& options, const RowRoom& room);
  /// @brief As beespace::count_neighbors.
  /// @param points The positions in metres.
  /// @param options The threshold and how to search.
  /// @param[out] counts The number of neighbours of each point; overwritten.
  /// @return Success, or an error of beespace::count_neighbors.
  Status count_neighbors(const PointsView& points, const SearchOptions& options,
                         std::vector<std::uint32_t>& counts);
  /// @brief As beespace::count_neighbors_between.
  /// @param points The positions in metres, each of which has a count.
  /// @param others The positions in metres of the other set.
  /// @param options The threshold and how to search.
  /// @param[out] counts The number of neighbours among `others` of each of `points`; overwritten.
  /// @return Success, or an error of beespace::count_neighbors_between.
  Status count_neighbors_between(const PointsView& points, const PointsView& others,
                                 const SearchOptions& options, std::vector<std::uint32_t>& counts);

  /// @brief As beespace::find_conflict_groups.
  /// @param points The positions in metres.
  /// @param options The threshold and how to search.
  /// @param[out] groups A row of ids for each group; overwritten.
  /// @return Success, or an error of beespace::find_conflict_groups.
  Status find_conflict_groups(const PointsView& points, const SearchOptions& options,
                              IdRows& groups);

  /// @brief As beespace::find_nearest.
  /// @param points The positions in metres.
  /// @param[out] nearest The nearest other point of each point; overwritten.
  /// @param run How many threads may work (of an Engine with a Crew: all of it), and what ends the
  ///   call early.
  /// @return Success, or an error of beespace::find_nearest.
  Status find_nearest(const PointsView& points, std::vector<Nearest>& nearest,
                      const RunOptions& run = {});
  /// @brief As beespace::find_k_nearest.
  /// @param points The positions in metres.
  /// @param k How many neighbours to find for each point.
  /// @param[out] nearest A row for each point; overwritten.
  /// @param run How many threads may work (of an Engine with a Crew: all of it), and what ends the
  ///   call early.
  /// @return Success, or an error of beespace::find_k_nearest.
  Status find_k_nearest(const PointsView& points, std::size_t k, NearestRows& nearest,
                        const RunOptions& run = {});
  /// @brief As beespace::find_nearest_within.
  /// @param points The positions in metres.
  /// @param options The threshold and how to search.
  /// @param[out] nearest The nearest of each point's neighbours; overwritten.
  /// @return Success, or an error of beespace::find_nearest_within.
  Status find_nearest_within(const PointsView& points, const SearchOptions& options,
                             std::vector<Nearest>& nearest);
  /// @brief As beespace::find_nearest_between.
  /// @param points The positions in metres, each of which has an entry.
  /// @param others The positions in metres of the other set.
  /// @param[out] nearest The nearest of `others` to each of `points`; overwritten.
  /// @param run How many threads may work (of an Engine with a Crew: all of it), and what ends the
  ///   call early.
  /// @return Success, or an error of beespace::find_nearest_between.
  Status find_nearest_between(const PointsView& points, const PointsView& others,
                              std::vector<Nearest>& nearest, const RunOptions& run = {});
  /// @brief As beespace::find_nearest_within_between.
  /// @param points The positions in metres, each of which has an entry.
  /// @param others The positions in metres of the other set.
  /// @param options The threshold and how to search.
  /// @param[out] nearest The nearest of each point's neighbours among `others`; overwritten.
  /// @return Success, or an error of beespace::find_nearest_within_between.
  Status find_nearest_within_between(const PointsView& points, const PointsView& others,
                                     const SearchOptions& options, std::vector<Nearest>& nearest);

  /// @brief As beespace::find_closest_pair.
  /// @param points The positions in metres.
  /// @param run How many threads may work (of an Engine with a Crew: all of it), and what ends the
  ///   call early.
  /// @return As beespace::find_closest_pair.
  Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points,
                                                       const RunOptions& run = {});
  /// @brief As beespace::find_closest_pair_between.
  /// @param points The positions in metres of the first of the pair.
  /// @param others The positions in metres of the second of the pair.
  /// @param run How many threads may work (of an Engine with a Crew: all of it), and what ends the
  ///   call early.
  /// @return As beespace::find_closest_pair_between.
  Result<std::optional<ClosestPair>> find_closest_pair_between(const PointsView& points,
                                                               const PointsView& others,
                                                               const RunOptions& run = {});

  /// @brief As beespace::predict_conflicts.
  /// @param movers The agents, in metres and metres per second.
  /// @param options The threshold and the horizon.
  /// @param[out] conflicts The conflicts; overwritten.
  /// @return Success, or an error of beespace::predict_conflicts.
  Status predict_conflicts(const MoversView& movers, const PredictOptions& options,
                           std::vector<Conflict>& conflicts);
  /// @brief As beespace::predict_pairs.
  /// @param movers The agents, in metres and metres per second.
  /// @param options The threshold and the horizon.
  /// @param[out] pairs The pairs that are in conflict; overwritten.
  /// @return Success, or an error of beespace::predict_pairs.
  Status predict_pairs(const MoversView& movers, const PredictOptions& options,
                       std::vector<Pair>& pairs);

  /// @brief Gives the working memory back to the system.
  void release_memory();
  /// @brief Bounds the working memory that waits for another use. A call takes what it needs all
  /// the same; but before it takes more than this, it gives back what it has no use for. Swarms
  /// whose size changes from call to call otherwise keep memory of several sizes.
  /// @param bytes Of the memory of all calls of one thread, used and waiting; SIZE_MAX, as at
  /// first: no bound.
  void bound_memory(std::size_t bytes);

 private:
  class EngineState;
  std::unique_ptr<EngineState> state_;
};

}  // namespace beespace
