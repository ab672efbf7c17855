/// @file
/// @brief Which agents are about to come closer than the threshold?
///
/// Each agent moves on in a straight line at constant velocity until the horizon. The promises are
/// those of the search for snapshots: no pair is missed however fast or slow, no pair is reported
/// twice, and no rounding decides.
#pragma once

#include <beespace/closest_approach.hpp>
#include <beespace/conflict.hpp>
#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>

#include <vector>

namespace beespace {

/// @brief Finds all pairs that are in conflict at some instant of [0, horizon], as closest_approach
/// says of each two.
///
/// Thread safety: no state is kept.
///
/// @param movers The agents, in metres and metres per second; read in place, not kept.
/// @param options The threshold and the horizon.
/// @return The conflicts in ascending order of (first, second); each begins, is closest and ends
///   within [0, horizon]. Or an error as closest_approach, with the agent in ErrorLocation::record;
///   ErrorCode::kInvalidArgument for a view whose arrays differ in length;
///   ErrorCode::kTooManyPoints; ErrorCode::kTooManyResults when there are more than
///   PredictOptions::max_results; ErrorCode::kStopped when a stop was requested.
BEESPACE_API Result<std::vector<Conflict>> predict_conflicts(const MoversView& movers,
                                                             const PredictOptions& options);

/// @brief Finds the pairs of predict_conflicts, without when and how close.
///
/// Complexity: over a short time little more than the search of one snapshot. It serves to ask,
/// with every new fix, which pairs have come closer than the threshold since the last one. Thread
/// safety: no state is kept.
///
/// @param movers The agents, in metres and metres per second; read in place, not kept.
/// @param options The threshold and the horizon.
/// @return The pairs, in the order of predict_conflicts; or an error as predict_conflicts.
BEESPACE_API Result<std::vector<Pair>> predict_pairs(const MoversView& movers,
                                                     const PredictOptions& options);

}  // namespace beespace
