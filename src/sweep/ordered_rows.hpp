// Finds the near points of every point, in the order of their ids, row by row: for crowds, where
// rows are so long that to sort what was found takes longer than to find it.
//
//   a tile: query points beside each other in a row of the grid
//   --around its box-->    others, brought into the order of their ids once for the tile
//   --around a smaller box of a few of its points-->   fewer others, still in order
//   --each query point past them-->   its row, in order
//
// Rows are counted first, so that each can be written where it belongs, and nothing else is kept.
#pragma once

#include "base/resources.hpp"
#include "sweep/row_sweeps.hpp"

#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace beespace::cpu {

enum class Which : std::uint8_t { kAll, kAboveOnly };

// Writes how many others are near to each of the asked points, or how many of those above its own
// id; `lengths` is by sorted point. Stops early, with some missing, when there are more than
// `most`; returns how many there are, or more than `most`.
std::uint64_t count_rows(const SweepQuery& question, Which which, const core::Resources& with,
                         std::uint64_t most, std::uint32_t* lengths);

// The ids of one row, ascending. Several workers call it at once.
using VisitRow = std::function<void(std::uint32_t asked, const PointId* ids, std::size_t count)>;

// Calls visit with all rows that count_rows found not to be empty.
void visit_rows(const SweepQuery& question, Which which, const core::Resources& with,
                const std::uint32_t* lengths, const VisitRow& visit);

}  // namespace beespace::cpu
