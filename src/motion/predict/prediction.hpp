// The searches behind predict_conflicts and predict_pairs: steps of time to the horizon, candidates
// of each step, and an exact decision on each candidate that floats leave open.
#pragma once

#include "base/resources.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/closest_approach.hpp>
#include <beespace/conflict.hpp>
#include <beespace/mover.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <vector>

namespace beespace::motion {

// Chosen from the data unless a test or a benchmark forces it.
struct PredictionTuning {
  search::TuningOverrides search = {};
  std::optional<double> step_s = {};
};

// Of predict_conflicts and predict_pairs. Options are valid; on an error what is written is
// unspecified.
Status predict(const MoversView& movers, const PredictOptions& options, const core::Resources& with,
               std::vector<Conflict>& conflicts, const PredictionTuning& tuning = {});
Status predict_pairs(const MoversView& movers, const PredictOptions& options,
                     const core::Resources& with, std::vector<Pair>& pairs,
                     const PredictionTuning& tuning = {});

}  // namespace beespace::motion
