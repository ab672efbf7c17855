// The queries of an Engine for pairs and neighbours: into vectors or columns.
#include <beespace/engine.hpp>

#include "base/answered.hpp"
#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "search/column_answer.hpp"
#include "search/cylinder_search.hpp"
#include "search/engine_state.hpp"
#include "search/pair_answer.hpp"
#include "search/pair_search.hpp"

#include <utility>

namespace beespace {

Status Engine::EngineState::find_pairs(const PointsView& points, const PointsView* others,
                                       const PairOptions& options, search::PairAnswer& answer) {
  if (is_vertical(options, points, others == nullptr ? PointsView() : *others)) {
    return run_cylinder(points, others, options,
                        [&](const auto& search) { return search.find_pairs(answer); });
  }
  if (auto error = core::check_options(options)) return *std::move(error);
  const auto search = [&](const auto& domain, const auto& with) {
    return search::find_pairs(domain, options, with, tuning, answer);
  };
  return others == nullptr ? run(points, options, search) : run(points, *others, options, search);
}

Status Engine::EngineState::find_neighbors(const PointsView& points, const PointsView* others,
                                           const PairOptions& options, search::PairAnswer& answer) {
  if (is_vertical(options, points, others == nullptr ? PointsView() : *others)) {
    return run_cylinder(points, others, options,
                        [&](const auto& search) { return search.find_neighbors(answer); });
  }
  if (auto error = core::check_options(options)) return *std::move(error);
  const auto search = [&](const auto& domain, const auto& with) {
    return search::find_neighbors(domain, options, with, tuning, answer);
  };
  return others == nullptr ? run(points, options, search) : run(points, *others, options, search);
}

Status Engine::find_pairs(const PointsView& points, const PairOptions& options,
                          std::vector<Pair>& pairs) {
  search::PairVector answer(pairs);
  return core::answered(pairs,
                        [&] { return state_->find_pairs(points, nullptr, options, answer); });
}

Status Engine::find_pairs_between(const PointsView& points, const PointsView& others,
                                  const PairOptions& options, std::vector<Pair>& pairs) {
  search::PairVector answer(pairs);
  return core::answered(pairs,
                        [&] { return state_->find_pairs(points, &others, options, answer); });
}

Status Engine::find_pairs(const PointsView& points, const PairOptions& options,
                          const PairRoom& room) {
  search::PairColumnsAnswer answer(room, points, points);
  return core::unless_stopped([&] { return state_->find_pairs(points, nullptr, options, answer); });
}

Status Engine::find_pairs_between(const PointsView& points, const PointsView& others,
                                  const PairOptions& options, const PairRoom& room) {
  search::PairColumnsAnswer answer(room, points, others);
  return core::unless_stopped([&] { return state_->find_pairs(points, &others, options, answer); });
}

Status Engine::find_neighbors(const PointsView& points, const PairOptions& options,
                              IdRows& neighbors) {
  search::RowVectors answer(neighbors, points.size());
  return core::answered(neighbors,
                        [&] { return state_->find_neighbors(points, nullptr, options, answer); });
}

Status Engine::find_neighbors_between(const PointsView& points, const PointsView& others,
                                      const PairOptions& options, IdRows& neighbors) {
  search::RowVectors answer(neighbors, points.size());
  return core::answered(neighbors,
                        [&] { return state_->find_neighbors(points, &others, options, answer); });
}

Status Engine::find_neighbors(const PointsView& points, const PairOptions& options,
                              const RowRoom& room) {
  search::RowColumnsAnswer answer(room, points, points);
  return core::unless_stopped(
      [&] { return state_->find_neighbors(points, nullptr, options, answer); });
}

Status Engine::find_neighbors_between(const PointsView& points, const PointsView& others,
                                      const PairOptions& options, const RowRoom& room) {
  search::RowColumnsAnswer answer(room, points, others);
  return core::unless_stopped(
      [&] { return state_->find_neighbors(points, &others, options, answer); });
}

}  // namespace beespace
