// The search behind predict_conflicts: steps of time to the horizon, candidates of each step, and
// an exact decision about each candidate.
#pragma once

#include "core/resources.hpp"
#include "search/choices.hpp"

#include <beespace/closest_approach.hpp>
#include <beespace/conflict.hpp>
#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <vector>

namespace beespace::motion {

// What is chosen from the data unless a test or a benchmark forces it.
struct PredictionChoices {
  search::Choices search = {};
  std::optional<double> step_s = {};
};

// Options and movers are valid.
Result<std::vector<Conflict>> predict(const MoversView& movers, const PredictOptions& options,
                                      const core::Resources& with,
                                      const PredictionChoices& choices = {});

}  // namespace beespace::motion
