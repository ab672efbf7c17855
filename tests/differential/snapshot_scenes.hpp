// Snapshots that are constructed to provoke wrong answers.
#pragma once

#include "tests/contract/inquiry.hpp"
#include "tests/differential/random.hpp"

#include <beespace/search_options.hpp>

#include <vector>

namespace beespace::differential {

struct SnapshotScene {
  test::Subject subject;               // its name is that of the layout
  std::vector<double> heights;         // apart from the positions; mostly empty
  std::vector<double> other_heights;   // of the other set
  std::vector<SearchOptions> options;  // to ask with; heights are not yet among them
};

// For queries with or without a vertical threshold.
SnapshotScene random_snapshot(Random& random, bool upright);

}  // namespace beespace::differential
