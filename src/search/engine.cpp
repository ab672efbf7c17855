// The queries of an Engine on snapshots, but for pairs and neighbours.
#include <beespace/engine.hpp>

#include "base/answered.hpp"
#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "search/at_risk_search.hpp"
#include "search/closest_pair_search.hpp"
#include "search/cylinder_search.hpp"
#include "search/engine_state.hpp"
#include "search/group_search.hpp"
#include "search/k_nearest_search.hpp"
#include "search/nearest_search.hpp"
#include "search/pair_search.hpp"

#include <optional>
#include <span>
#include <utility>

namespace beespace {

namespace {

constexpr std::monostate kDone{};

}  // namespace

Engine::Engine() : state_(std::make_unique<EngineState>(nullptr)) {
}
Engine::Engine(Crew& crew) : state_(std::make_unique<EngineState>(&crew)) {
}
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;
Engine::~Engine() = default;

void Engine::release_memory() {
  state_->memory().release();
}

void Engine::bound_memory(std::size_t bytes) {
  state_->memory().bound(bytes);
}

Status Engine::find_at_risk(const PointsView& points, const SearchOptions& options,
                            std::vector<PointId>& at_risk) {
  return core::answered(at_risk, [&]() -> Status {
    if (EngineState::is_vertical(options, points)) {
      return state_->run_cylinder(points, nullptr, options,
                                  [&](const auto& search) { return search.find_at_risk(at_risk); });
    }
    if (auto error = core::check_options(options)) return *std::move(error);
    return state_->run(points, options, [&](const auto& domain, const auto& with) {
      search::find_at_risk(domain, options, with, state_->tuning, at_risk);
      return kDone;
    });
  });
}

Status Engine::find_at_risk_between(const PointsView& points, const PointsView& others,
                                    const SearchOptions& options, std::vector<PointId>& at_risk) {
  return core::answered(at_risk, [&]() -> Status {
    if (EngineState::is_vertical(options, points, others)) {
      return state_->run_cylinder(points, &others, options,
                                  [&](const auto& search) { return search.find_at_risk(at_risk); });
    }
    if (auto error = core::check_options(options)) return *std::move(error);
    return state_->run(points, others, options, [&](const auto& domain, const auto& with) {
      search::find_at_risk(domain, options, with, state_->tuning, at_risk);
      return kDone;
    });
  });
}

Result<bool> Engine::visit_pairs(const PointsView& points, const SearchOptions& options,
                                 const PairVisitor& visit) {
  // What the visitor searches is not stopped with this search.
  const PairVisitor visit_freely = [&visit](std::span<const Pair> pairs) {
    bool goes_on = false;
    {
      const core::NotStopping scope;
      goes_on = visit(pairs);
    }
    return goes_on && !core::is_stopping();
  };
  return core::unless_stopped([&]() -> Result<bool> {
    if (EngineState::is_vertical(options, points)) {
      return state_->run_cylinder(points, nullptr, options, [&](const auto& search) {
        return search.visit_pairs(visit_freely);
      });
    }
    if (auto error = core::check_options(options)) return *std::move(error);
    bool saw_all = false;
    const Status status = state_->run(points, options, [&](const auto& domain, const auto& with) {
      saw_all = search::visit_pairs(domain, options, with, state_->tuning, visit_freely);
      return kDone;
    });
    if (!status) return status.error();
    return saw_all;
  });
}

Status Engine::count_neighbors(const PointsView& points, const SearchOptions& options,
                               std::vector<std::uint32_t>& counts) {
  return core::answered(counts, [&]() -> Status {
    if (EngineState::is_vertical(options, points)) {
      return state_->run_cylinder(points, nullptr, options, [&](const auto& search) {
        return search.count_neighbors(counts);
      });
    }
    if (auto error = core::check_options(options)) return *std::move(error);
    return state_->run(points, options, [&](const auto& domain, const auto& with) {
      search::count_neighbors(domain, options, with, state_->tuning, counts);
      return kDone;
    });
  });
}

Status Engine::count_neighbors_between(const PointsView& points, const PointsView& others,
                                       const SearchOptions& options,
                                       std::vector<std::uint32_t>& counts) {
  return core::answered(counts, [&]() -> Status {
    if (EngineState::is_vertical(options, points, others)) {
      return state_->run_cylinder(points, &others, options, [&](const auto& search) {
        return search.count_neighbors(counts);
      });
    }
    if (auto error = core::check_options(options)) return *std::move(error);
    return state_->run(points, others, options, [&](const auto& domain, const auto& with) {
      search::count_neighbors(domain, options, with, state_->tuning, counts);
      return kDone;
    });
  });
}

Status Engine::find_conflict_groups(const PointsView& points, const SearchOptions& options,
                                    IdRows& groups) {
  return core::answered(groups, [&]() -> Status {
    if (EngineState::is_vertical(options, points)) {
      return state_->run_cylinder(points, nullptr, options,
                                  [&](const auto& search) { return search.find_groups(groups); });
    }
    if (auto error = core::check_options(options)) return *std::move(error);
    return state_->run(points, options, [&](const auto& domain, const auto& with) {
      search::find_conflict_groups(domain, options, with, state_->tuning, groups);
      return kDone;
    });
  });
}

Status Engine::find_nearest(const PointsView& points, std::vector<Nearest>& nearest,
                            const RunOptions& run) {
  return core::answered(nearest, [&]() -> Status {
    if (auto error = core::check_no_heights(points, core::kPointsName)) return *std::move(error);
    return state_->run(points, run, [&](const auto& domain, const auto& with) {
      search::find_nearest(domain, std::nullopt, with, state_->tuning, nearest);
      return kDone;
    });
  });
}

Status Engine::find_k_nearest(const PointsView& points, std::size_t k, NearestRows& nearest,
                              const RunOptions& run) {
  return core::answered(nearest, [&]() -> Status {
    const core::Resources with = state_->resources(run, points.size());
    if (auto error = core::check_no_heights(points, core::kPointsName)) return *std::move(error);
    if (auto error = core::check_size(points)) return *std::move(error);
    const Result<core::Bounds> bounds = core::measure(points, with);
    if (!bounds) return bounds.error();
    std::vector<core::NearestList>& lists = state_->nearest_lists;
    if (lists.size() < with.crew.size()) lists.resize(with.crew.size());
    search::find_k_nearest(points, *bounds, k, with, state_->tuning, lists, nearest);
    return kDone;
  });
}

Status Engine::find_nearest_within(const PointsView& points, const SearchOptions& options,
                                   std::vector<Nearest>& nearest) {
  return core::answered(nearest, [&]() -> Status {
    if (EngineState::is_vertical(options, points)) {
      return state_->run_cylinder(points, nullptr, options,
                                  [&](const auto& search) { return search.find_nearest(nearest); });
    }
    if (auto error = core::check_options(options)) return *std::move(error);
    return state_->run(points, options, [&](const auto& domain, const auto& with) {
      search::find_nearest(domain, options, with, state_->tuning, nearest);
      return kDone;
    });
  });
}

Status Engine::find_nearest_between(const PointsView& points, const PointsView& others,
                                    std::vector<Nearest>& nearest, const RunOptions& run) {
  return core::answered(nearest, [&]() -> Status {
    if (auto error = core::check_no_heights(points, core::kPointsName)) return *std::move(error);
    if (auto error = core::check_no_heights(others, core::kOthersName)) return *std::move(error);
    return state_->run(points, others, run, [&](const auto& domain, const auto& with) {
      search::find_nearest(domain, std::nullopt, with, state_->tuning, nearest);
      return kDone;
    });
  });
}

Status Engine::find_nearest_within_between(const PointsView& points, const PointsView& others,
                                           const SearchOptions& options,
                                           std::vector<Nearest>& nearest) {
  return core::answered(nearest, [&]() -> Status {
    if (EngineState::is_vertical(options, points, others)) {
      return state_->run_cylinder(points, &others, options,
                                  [&](const auto& search) { return search.find_nearest(nearest); });
    }
    if (auto error = core::check_options(options)) return *std::move(error);
    return state_->run(points, others, options, [&](const auto& domain, const auto& with) {
      search::find_nearest(domain, options, with, state_->tuning, nearest);
      return kDone;
    });
  });
}

Result<std::optional<ClosestPair>> Engine::find_closest_pair(const PointsView& points,
                                                             const RunOptions& run) {
  using Closest = std::optional<ClosestPair>;
  return core::unless_stopped([&]() -> Result<Closest> {
    if (auto error = core::check_no_heights(points, core::kPointsName)) return *std::move(error);
    Closest closest;
    const Status status = state_->run(points, run, [&](const auto& domain, const auto& with) {
      if (points.size() < 2) return kDone;
      const Pair pair = search::find_closest_pair(domain, with, state_->tuning);
      closest = {pair.first, pair.second, distance(points[pair.first], points[pair.second])};
      return kDone;
    });
    if (!status) return status.error();
    return closest;
  });
}

Result<std::optional<ClosestPair>> Engine::find_closest_pair_between(const PointsView& points,
                                                                     const PointsView& others,
                                                                     const RunOptions& run) {
  using Closest = std::optional<ClosestPair>;
  return core::unless_stopped([&]() -> Result<Closest> {
    if (auto error = core::check_no_heights(points, core::kPointsName)) return *std::move(error);
    if (auto error = core::check_no_heights(others, core::kOthersName)) return *std::move(error);
    Closest closest;
    const Status status =
        state_->run(points, others, run, [&](const auto& domain, const auto& with) {
          closest = search::find_closest_between(domain, with, state_->tuning, state_->nearest);
          return kDone;
        });
    if (!status) return status.error();
    return closest;
  });
}

}  // namespace beespace
