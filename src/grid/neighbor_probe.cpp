#include "grid/neighbor_probe.hpp"

#include "base/hash.hpp"
#include "base/point_block.hpp"
#include "grid/near_pairs.hpp"
#include "grid/neighbour_rows.hpp"
#include "grid/position_block.hpp"

#include <algorithm>
#include <bit>

namespace beespace::core {

namespace {

std::uint64_t slot_of(std::uint64_t x, std::uint64_t y, std::uint64_t z, std::uint64_t mask) {
  return (hash_cell(x, y, z) >> 20) & mask;
}

template <class Visit>
void for_each_cell(const Selection& selected, const Lattice& lattice, std::size_t begin,
                   std::size_t end, Visit&& visit) {
  const unsigned shift = lattice.fraction_bits();
  for_each_position_block(selected, lattice, begin, end,
                          [&](const PositionBlock& at, std::size_t first, std::size_t count) {
                            for (std::size_t i = 0; i < count; ++i) {
                              visit(first + i, static_cast<std::uint64_t>(at[0][i] >> shift),
                                    static_cast<std::uint64_t>(at[1][i] >> shift),
                                    static_cast<std::uint64_t>(at[2][i] >> shift));
                            }
                          });
}

}  // namespace

Vector<PointId> surroundings(const Selection& asked, const Selection& others,
                             const Lattice& lattice, const Resources& with) {
  // A bit for each of the 27 cells around a query point, one in sixteen bits set at most.
  const std::uint64_t bits = std::bit_ceil(asked.size() * 27 * 16 + 64);
  Vector<std::uint64_t> near(bits / 64, &with.memory);
  for_each_cell(asked, lattice, 0, asked.size(),
                [&](std::size_t, std::uint64_t x, std::uint64_t y, std::uint64_t z) {
                  for (std::uint64_t k = 0; k < 27; ++k) {
                    const std::uint64_t slot =
                        slot_of(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1, bits - 1);
                    near[slot / 64] |= std::uint64_t{1} << slot % 64;
                  }
                });
  PerWorker<PointId> found(with);
  with.crew.split(others.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    for_each_cell(others, lattice, begin, end,
                  [&](std::size_t i, std::uint64_t x, std::uint64_t y, std::uint64_t z) {
                    const std::uint64_t slot = slot_of(x, y, z, bits - 1);
                    if ((near[slot / 64] >> slot % 64 & 1) == 0) return;
                    found[worker].push_back(others.id(i));
                  });
  });
  return std::move(found).joined();
}

void probe_neighbors(const SortedGrid& grid, const PointsView& points, const ProximityTest& closer,
                     double threshold, const Resources& with, std::uint8_t* at_risk) {
  const SquaredLimits limits(threshold, grid.units_per_m);
  with.crew.split(grid.rows(), [&](std::size_t begin, std::size_t end, unsigned) {
    NeighbourRows around(grid, grid);
    for (std::size_t row = begin; row < end; ++row) {
      bool selected = false;
      for (std::uint32_t i = grid.row_begin[row]; i < grid.row_begin[row + 1]; ++i) {
        if (at_risk[grid.id[i]] != 0) continue;
        if (!selected) around.select(row);
        selected = true;
        const bool company =
            around.any_near(i, limits.surely_far, [&](std::uint32_t j, float squared) {
              if (i == j) return false;
              return squared < limits.surely_near || closer(points[grid.id[i]], points[grid.id[j]]);
            });
        if (company) at_risk[grid.id[i]] = 1;
      }
    }
  });
}

}  // namespace beespace::core
