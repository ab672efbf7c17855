// Movers in whole numbers: which two are in conflict until the horizon, and whether what is
// reported of them is true.
#pragma once

#include "tests/differential/passage.hpp"

#include <beespace/closest_approach.hpp>
#include <beespace/conflict.hpp>
#include <beespace/pairs.hpp>

#include <string>
#include <vector>

namespace beespace::differential {

// A mover; its height and climb count where heights are kept apart.
struct Flight {
  Mover mover;
  double height = 0.0;
  double climb = 0.0;
};

bool in_conflict(const Flight& a, const Flight& b, const PredictOptions& options, bool apart);

std::vector<Pair> pairs_in_conflict(const std::vector<Flight>& flights,
                                    const PredictOptions& options, bool apart);

// The error in the times and distances of a conflict, or nothing. By the promise of
// tests/motion/recorded/reported_times_test.cpp: positions at the reported instants are wrong by no
// more than 2^-48 of how far apart the two begin and of the thresholds.
std::string fault_of(const Conflict& conflict, const Flight& a, const Flight& b,
                     const PredictOptions& options, bool apart);

}  // namespace beespace::differential
