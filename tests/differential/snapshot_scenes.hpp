// Moments of a swarm that are made to be told wrongly.
#pragma once

#include "tests/contract/inquiry.hpp"
#include "tests/differential/random.hpp"

#include <beespace/search_options.hpp>

#include <vector>

namespace beespace::differential {

struct SnapshotScene {
  test::Subject subject;             // its name is that of the layout
  std::vector<PairOptions> options;  // to ask with
};

// To be asked about with a vertical threshold, or without.
SnapshotScene random_snapshot(Random& random, bool upright);

}  // namespace beespace::differential
