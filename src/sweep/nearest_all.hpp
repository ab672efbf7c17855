// Finds nearest others by sweeping whole grids with all threads.
#pragma once

#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "sweep/row_sweeps.hpp"

#include <beespace/point.hpp>

namespace beespace::cpu {

// Writes to nearest[id] of every asked point the id of its nearest other among those that the
// grids' lattice lets it compare with: all within the lattice's reach, and some beyond. Exactly,
// ties to the lowest id; Nearest::kNone where there is none. No working memory.
void nearest_all(const SweepQuery& question, const core::Resources& with, PointId* nearest);

}  // namespace beespace::cpu
