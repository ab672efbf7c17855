// Snapshots that are constructed to provoke wrong answers.
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

// For queries with or without a vertical threshold.
SnapshotScene random_snapshot(Random& random, bool upright);

}  // namespace beespace::differential
