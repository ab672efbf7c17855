#include <beespace/brute_force.hpp>
#include <beespace/engine.hpp>
#include <beespace/predict_conflicts.hpp>

#include "base/answered.hpp"
#include "exact/validate.hpp"
#include "motion/flushed_copies.hpp"
#include "motion/predict/prediction.hpp"
#include "motion/separation.hpp"
#include "motion/validate.hpp"
#include "search/engine_state.hpp"

#include <string>
#include <utility>

namespace beespace {

namespace {

// Checks all of the input except the movers' values.
std::optional<Error> check(const MoversView& movers, const PredictOptions& options) {
  if (auto error = motion::check_options(options)) return error;
  if (auto error = motion::check_heights(movers.has_heights(), options.vertical_m)) return error;
  return motion::check_size(movers);
}

}  // namespace

Status Engine::predict_conflicts(const MoversView& movers, const PredictOptions& options,
                                 std::vector<Conflict>& conflicts) {
  return core::answered(conflicts, [&]() -> Status {
    if (auto error = check(movers, options)) return *std::move(error);
    const core::Resources with = state_->resources(options, movers.size());
    return motion::with_small_values_flushed(movers, [&](const MoversView& them) {
      return motion::predict(them, options, with, conflicts, {state_->tuning, {}});
    });
  });
}

Status Engine::predict_pairs(const MoversView& movers, const PredictOptions& options,
                             std::vector<Pair>& pairs) {
  return core::answered(pairs, [&]() -> Status {
    if (auto error = check(movers, options)) return *std::move(error);
    const core::Resources with = state_->resources(options, movers.size());
    return motion::with_small_values_flushed(movers, [&](const MoversView& them) {
      return motion::predict_pairs(them, options, with, pairs, {state_->tuning, {}});
    });
  });
}

Result<std::vector<Conflict>> predict_conflicts(const MoversView& movers,
                                                const PredictOptions& options) {
  std::vector<Conflict> conflicts;
  Status status = Engine().predict_conflicts(movers, options, conflicts);
  if (!status) return std::move(status).error();
  return conflicts;
}

Result<std::vector<Pair>> predict_pairs(const MoversView& movers, const PredictOptions& options) {
  std::vector<Pair> pairs;
  Status status = Engine().predict_pairs(movers, options, pairs);
  if (!status) return std::move(status).error();
  return pairs;
}

namespace brute_force {

namespace {

Result<std::vector<Conflict>> predict_in_domain(const MoversView& movers,
                                                const PredictOptions& options) {
  if (auto error = motion::check_movers(movers)) return *std::move(error);
  const motion::Separation separation = motion::separation_of(options, movers.has_heights());
  std::vector<Conflict> conflicts;
  for (PointId i = 0; i < movers.size(); ++i) {
    for (PointId j = i + 1; j < movers.size(); ++j) {
      const motion::State a = motion::state_of(movers, i);
      const motion::State b = motion::state_of(movers, j);
      if (!motion::in_conflict(a, b, separation, options.horizon_s)) continue;
      const auto report =
          motion::report_conflict(motion::relative_motion(a, b), separation, options.horizon_s);
      conflicts.push_back(
          {i, j, report.span.begins_s, report.closest_s, report.span.ends_s, report.closest_m});
      if (conflicts.size() > options.max_results) {
        return core::too_many_results(options.max_results);
      }
    }
  }
  return conflicts;
}

}  // namespace

Result<std::vector<Conflict>> predict_conflicts(const MoversView& movers,
                                                const PredictOptions& options) {
  if (auto error = check(movers, options)) return *std::move(error);
  return motion::with_small_values_flushed(
      movers, [&](const MoversView& them) { return predict_in_domain(them, options); });
}

}  // namespace brute_force

}  // namespace beespace
