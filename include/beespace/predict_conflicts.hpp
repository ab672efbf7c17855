// Who is about to come too close to whom?
//
// Everybody moves on in a straight line at constant velocity until the horizon. The promises are
// those of the search for snapshots: nobody is missed however fast or slow, nobody is reported
// twice, and no rounding decides.
#pragma once

#include <beespace/closest_approach.hpp>
#include <beespace/conflict.hpp>
#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>

#include <vector>

namespace beespace {

// All pairs that are in conflict at some instant of [0, horizon], as closest_approach says of each
// two, in ascending order of (first, second). Each begins, is closest and ends within [0, horizon].
//
// Errors: as closest_approach, with the mover in place.record; kTooManyPoints, kTooManyResults.
BEESPACE_API Result<std::vector<Conflict>> predict_conflicts(const MoversView& movers,
                                                             const PredictOptions& options);

// Who they are, without when and how close: the pairs of predict_conflicts, in the same order. Over
// a short time this costs little more than the search of one snapshot: for asking, with every new
// fix, who has come too close since the last one.
//
// Errors: as predict_conflicts.
BEESPACE_API Result<std::vector<Pair>> predict_pairs(const MoversView& movers,
                                                     const PredictOptions& options);

}  // namespace beespace
