// The searches as plain functions: an Engine for one call each.
#include <beespace/at_risk.hpp>
#include <beespace/conflict_groups.hpp>
#include <beespace/engine.hpp>
#include <beespace/nearest.hpp>
#include <beespace/neighbors.hpp>
#include <beespace/pairs.hpp>

#include "base/memory.hpp"
#include "search/column_answer.hpp"

#include <algorithm>
#include <utility>

namespace beespace {

namespace {

// The answer that ask(engine, answer) writes, or its error.
template <class Answer, class Ask>
Result<Answer> answer_of(Ask&& ask) {
  Engine engine;
  Answer answer;
  Status status = ask(engine, answer);
  if (!status) return std::move(status).error();
  return answer;
}

}  // namespace

Result<std::vector<PointId>> find_at_risk(const PointsView& points, const SearchOptions& options) {
  return answer_of<std::vector<PointId>>(
      [&](Engine& engine, auto& answer) { return engine.find_at_risk(points, options, answer); });
}

Result<std::vector<PointId>> find_at_risk_between(const PointsView& points,
                                                  const PointsView& others,
                                                  const SearchOptions& options) {
  return answer_of<std::vector<PointId>>([&](Engine& engine, auto& answer) {
    return engine.find_at_risk_between(points, others, options, answer);
  });
}

Result<std::vector<Pair>> find_pairs(const PointsView& points, const PairOptions& options) {
  return answer_of<std::vector<Pair>>(
      [&](Engine& engine, auto& answer) { return engine.find_pairs(points, options, answer); });
}

Result<std::vector<Pair>> find_pairs_between(const PointsView& points, const PointsView& others,
                                             const PairOptions& options) {
  return answer_of<std::vector<Pair>>([&](Engine& engine, auto& answer) {
    return engine.find_pairs_between(points, others, options, answer);
  });
}

Result<bool> visit_pairs(const PointsView& points, const SearchOptions& options,
                         const PairVisitor& visit) {
  return Engine().visit_pairs(points, options, visit);
}

Result<IdRows> find_neighbors(const PointsView& points, const PairOptions& options) {
  return answer_of<IdRows>(
      [&](Engine& engine, auto& answer) { return engine.find_neighbors(points, options, answer); });
}

Result<IdRows> find_neighbors_between(const PointsView& points, const PointsView& others,
                                      const PairOptions& options) {
  return answer_of<IdRows>([&](Engine& engine, auto& answer) {
    return engine.find_neighbors_between(points, others, options, answer);
  });
}

Result<std::vector<std::uint32_t>> count_neighbors(const PointsView& points,
                                                   const SearchOptions& options) {
  return answer_of<std::vector<std::uint32_t>>([&](Engine& engine, auto& answer) {
    return engine.count_neighbors(points, options, answer);
  });
}

Result<std::vector<std::uint32_t>> count_neighbors_between(const PointsView& points,
                                                           const PointsView& others,
                                                           const SearchOptions& options) {
  return answer_of<std::vector<std::uint32_t>>([&](Engine& engine, auto& answer) {
    return engine.count_neighbors_between(points, others, options, answer);
  });
}

Result<IdRows> find_conflict_groups(const PointsView& points, const SearchOptions& options) {
  return answer_of<IdRows>([&](Engine& engine, auto& answer) {
    return engine.find_conflict_groups(points, options, answer);
  });
}

Result<std::vector<Nearest>> find_nearest(const PointsView& points, const RunOptions& run) {
  return answer_of<std::vector<Nearest>>(
      [&](Engine& engine, auto& answer) { return engine.find_nearest(points, answer, run); });
}

Result<NearestRows> find_k_nearest(const PointsView& points, std::size_t k, const RunOptions& run) {
  return answer_of<NearestRows>(
      [&](Engine& engine, auto& answer) { return engine.find_k_nearest(points, k, answer, run); });
}

Result<std::vector<Nearest>> find_nearest_within(const PointsView& points,
                                                 const SearchOptions& options) {
  return answer_of<std::vector<Nearest>>([&](Engine& engine, auto& answer) {
    return engine.find_nearest_within(points, options, answer);
  });
}

Result<std::vector<Nearest>> find_nearest_between(const PointsView& points,
                                                  const PointsView& others, const RunOptions& run) {
  return answer_of<std::vector<Nearest>>([&](Engine& engine, auto& answer) {
    return engine.find_nearest_between(points, others, answer, run);
  });
}

Result<std::vector<Nearest>> find_nearest_within_between(const PointsView& points,
                                                         const PointsView& others,
                                                         const SearchOptions& options) {
  return answer_of<std::vector<Nearest>>([&](Engine& engine, auto& answer) {
    return engine.find_nearest_within_between(points, others, options, answer);
  });
}

Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points,
                                                     const RunOptions& run) {
  return Engine().find_closest_pair(points, run);
}

Result<std::optional<ClosestPair>> find_closest_pair_between(const PointsView& points,
                                                             const PointsView& others,
                                                             const RunOptions& run) {
  return Engine().find_closest_pair_between(points, others, run);
}

std::vector<double> pair_distances(const PointsView& points, std::span<const Pair> pairs) {
  return pair_distances_between(points, points, pairs);
}

std::vector<double> pair_distances_between(const PointsView& points, const PointsView& others,
                                           std::span<const Pair> pairs) {
  // Made longer a piece at a time, which is then in the nearest cache.
  constexpr std::size_t kAtOnce = 4096;
  std::vector<double> distances_m;
  distances_m.reserve(pairs.size());
  core::advise_huge_pages(distances_m.data(), pairs.size() * sizeof(double));
  const search::PairDistances distances(points, others);
  for (std::size_t begin = 0; begin < pairs.size(); begin += kAtOnce) {
    const std::size_t end = std::min(begin + kAtOnce, pairs.size());
    distances_m.resize(end);
    for (std::size_t i = begin; i < end; ++i) {
      distances.write(distances_m.data(), i, pairs[i], {pairs.data(), 0, pairs.size(), 0, 0});
    }
  }
  return distances_m;
}

}  // namespace beespace
