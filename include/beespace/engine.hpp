// The searches of beespace for those who ask again and again: frame after frame of a swarm.
//
// An Engine keeps its working memory and its threads between calls, and writes answers into the
// caller's own containers. Once it has seen two frames like those that follow, a call allocates
// nothing; a frame much fuller or emptier than those may be searched in another way, and allocate
// again. The answers are those of the functions of the same name.
//
// Ownership: an Engine owns its memory and threads; a Crew given to it must outlive it. Not
// thread-safe: use one Engine a thread (they may share a ThreadCrew). On an error the answer is
// empty.
#pragma once

#include <beespace/closest_approach.hpp>
#include <beespace/conflict.hpp>
#include <beespace/crew.hpp>
#include <beespace/export.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/mover.hpp>
#include <beespace/nearest.hpp>
#include <beespace/pairs.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace beespace {

class BEESPACE_API Engine {
 public:
  // With threads of its own, as many as SearchOptions::threads says at each call.
  Engine();
  // With the threads of `crew`, all of which work on every call: SearchOptions::threads is ignored.
  explicit Engine(Crew& crew);
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;
  ~Engine();

  Status find_at_risk(const PointsView& points, const SearchOptions& options,
                      std::vector<PointId>& at_risk);
  Status find_at_risk_between(const PointsView& points, const PointsView& others,
                              const SearchOptions& options, std::vector<PointId>& at_risk);

  Status find_pairs(const PointsView& points, const SearchOptions& options,
                    std::vector<Pair>& pairs);
  Status find_pairs_between(const PointsView& points, const PointsView& others,
                            const SearchOptions& options, std::vector<Pair>& pairs);
  Result<bool> visit_pairs(const PointsView& points, const SearchOptions& options,
                           const PairVisitor& visit);

  Status find_neighbors(const PointsView& points, const SearchOptions& options, IdRows& neighbors);
  Status find_neighbors_between(const PointsView& points, const PointsView& others,
                                const SearchOptions& options, IdRows& neighbors);
  Status count_neighbors(const PointsView& points, const SearchOptions& options,
                         std::vector<std::uint32_t>& counts);
  Status count_neighbors_between(const PointsView& points, const PointsView& others,
                                 const SearchOptions& options, std::vector<std::uint32_t>& counts);

  Status find_conflict_groups(const PointsView& points, const SearchOptions& options,
                              IdRows& groups);

  Status find_nearest(const PointsView& points, std::vector<Nearest>& nearest,
                      unsigned threads = 1);
  Status find_nearest_within(const PointsView& points, const SearchOptions& options,
                             std::vector<Nearest>& nearest);
  Status find_nearest_between(const PointsView& points, const PointsView& others,
                              std::vector<Nearest>& nearest, unsigned threads = 1);
  Status find_nearest_within_between(const PointsView& points, const PointsView& others,
                                     const SearchOptions& options, std::vector<Nearest>& nearest);

  Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points,
                                                       unsigned threads = 1);
  Result<std::optional<ClosestPair>> find_closest_pair_between(const PointsView& points,
                                                               const PointsView& others,
                                                               unsigned threads = 1);

  Status predict_conflicts(const MoversView& movers, const PredictOptions& options,
                           std::vector<Conflict>& conflicts);
  Status predict_pairs(const MoversView& movers, const PredictOptions& options,
                       std::vector<Pair>& pairs);

  // Gives the working memory back to the system.
  void release_memory();

 private:
  class EngineState;
  std::unique_ptr<EngineState> state_;
};

}  // namespace beespace
