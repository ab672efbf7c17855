// How many bees have their nearest neighbour how far away.
#pragma once

#include "report/facts.hpp"
#include "report/figure/panel.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::report {

struct Histogram {
  std::vector<double> edges_m;         // ascending, one more than counts; the threshold is one
  std::vector<std::uint64_t> counts;   // bin i: from edges_m[i] up to below edges_m[i + 1]
  std::vector<std::uint64_t> at_risk;  // of these
  bool logarithmic = false;            // where distances are spread over powers of ten
  std::uint64_t below = 0;             // of logarithmic ones: at no distance, or nearly; in bin 0
};

// Nothing where no bee has a neighbour.
std::optional<Histogram> nearest_histogram(const SnapshotFacts& facts);

// The part of each bar that is at risk is dark, at its foot.
void draw_histogram(const Histogram& histogram, const SwarmFacts& swarm, const Box& box,
                    Drawing& drawing);

}  // namespace beespace::report
