// A block of positions in a loop: coordinates in a lattice, in one short array an axis, which the
// compiler can vectorise over.
#pragma once

#include "base/point_block.hpp"
#include "grid/lattice.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace beespace::core {

// Lattice positions of a block: one short array an axis.
using PositionBlock = std::array<std::array<std::int32_t, PointBlock::kSize>, 3>;

// Calls visit(positions, first, count) for the points [begin, end) of a selection in blocks.
template <class Visit>
void for_each_position_block(const Selection& selected, const Lattice& lattice, std::size_t begin,
                             std::size_t end, Visit&& visit) {
  PositionBlock positions;
  if (const auto given = interleaved(selected.points);
      given && !selected.ids && !lattice.folded()) {
    for_each_block(begin, end, [&](std::size_t first, std::size_t count) {
      const double* const xyz = given->xyz + 3 * first;
      prefetch_behind(xyz, count);
      lattice.positions(xyz, given->place, count,
                        {positions[0].data(), positions[1].data(), positions[2].data()});
      visit(positions, first, count);
    });
    return;
  }
  PointBlock block;
  for_each_block(begin, end, [&](std::size_t first, std::size_t count) {
    block.load(selected, first, count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lattice.positions(axis, block.axis(axis), count, positions[axis].data());
    }
    visit(positions, first, count);
  });
}

}  // namespace beespace::core
