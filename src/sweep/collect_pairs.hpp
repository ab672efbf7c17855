// Finds near pairs by sweeping whole grids with all threads.
#pragma once

#include "base/pair_order.hpp"
#include "base/resources.hpp"
#include "sweep/row_sweeps.hpp"

#include <beespace/pairs.hpp>

#include <cstdint>

namespace beespace::cpu {

// The near pairs of each worker: every pair once, asked point first. Stops early, with pairs
// missing, when there are more than `most`.
core::Vector<core::FoundPairs> collect_pairs(const SweepQuery& question,
                                             const core::Resources& with, std::uint64_t most);

// Shows every near pair of a swarm by itself to `visit`, lower id first, by the batch, until it
// returns false; returns whether it never did.
bool show_pairs(const SweepQuery& question, const core::Resources& with, const PairVisitor& visit);

}  // namespace beespace::cpu
