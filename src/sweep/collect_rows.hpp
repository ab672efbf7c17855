// Finds the near points of every point, row by row, with all threads: for crowds, where it is
// cheaper to compare every pair from both sides than to sort pairs.
#pragma once

#include "base/resources.hpp"
#include "base/row_order.hpp"
#include "sweep/row_sweeps.hpp"

#include <cstdint>

namespace beespace::cpu {

enum class Which : std::uint8_t { kAll, kAboveOnly };

// The ids of all others that are near to each of the asked points, or of those above its own, in
// any order. Stops early, with some missing, when there are more than `most`; `total` is how many
// there are, or more than `most`. Working memory: 4 bytes a point and near one.
core::AllFoundRows collect_rows(const SweepQuery& question, Which which,
                                const core::Resources& with, std::uint64_t most,
                                std::uint64_t& total);

}  // namespace beespace::cpu
