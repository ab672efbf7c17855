// Finds nearest others by sweeping whole grids with all threads.
#pragma once

#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "sweep/row_sweeps.hpp"

#include <beespace/point.hpp>

namespace beespace::cpu {

// Writes to nearest[id] of every asked point the id of its nearest other within the far limit of
// the question. Exactly, ties to the lowest id. Where there is none, any or none of those that the
// grids' lattice lets it compare with, or Nearest::kNone. No working memory.
void nearest_all(const SweepQuery& question, const core::Resources& with, PointId* nearest);

}  // namespace beespace::cpu
