#include "core/look_around.hpp"

#include "core/hash.hpp"
#include "core/near_pairs.hpp"
#include "core/neighbour_rows.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace beespace::core {

namespace {

std::uint64_t slot_of(std::uint64_t x, std::uint64_t y, std::uint64_t z, std::uint64_t mask) {
  return (hash_cell(x, y, z) >> 20) & mask;
}

}  // namespace

std::vector<PointId> surroundings(const PointsView& points, const Lattice& lattice,
                                  std::span<const PointId> asked, Crew& crew) {
  const auto cell_of = [&](PointId id) {
    std::array<std::uint64_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = lattice.cell(axis, points.coordinate(axis, id));
    }
    return cell;
  };

  // A bit for each of the 27 cells around a point asked for, one in sixteen bits set at most.
  const std::uint64_t bits = std::bit_ceil(asked.size() * 27 * 16 + 64);
  std::vector<std::uint64_t> near(bits / 64);
  for (const PointId id : asked) {
    const auto [x, y, z] = cell_of(id);
    for (std::uint64_t k = 0; k < 27; ++k) {
      const std::uint64_t slot = slot_of(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1, bits - 1);
      near[slot / 64] |= std::uint64_t{1} << slot % 64;
    }
  }
  std::vector<std::vector<PointId>> found(crew.size());
  crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto id = static_cast<PointId>(i);
      const auto [x, y, z] = cell_of(id);
      const std::uint64_t slot = slot_of(x, y, z, bits - 1);
      if ((near[slot / 64] >> slot % 64 & 1) != 0) found[worker].push_back(id);
    }
  });
  for (unsigned worker = 1; worker < crew.size(); ++worker) {
    found[0].insert(found[0].end(), found[worker].begin(), found[worker].end());
  }
  return std::move(found[0]);
}

void look_around(const SortedGrid& grid, const PointsView& points, const ProximityTest& closer,
                 double threshold, Crew& crew, std::uint8_t* at_risk) {
  const SquaredLimits limits(threshold, grid.units_per_m);
  crew.split(grid.rows(), [&](std::size_t begin, std::size_t end, unsigned) {
    NeighbourRows around(grid);
    for (std::size_t row = begin; row < end; ++row) {
      bool selected = false;
      for (std::uint32_t i = grid.row_begin[row]; i < grid.row_begin[row + 1]; ++i) {
        if (at_risk[grid.id[i]] != 0) continue;
        if (!selected) around.select(row);
        selected = true;
        const bool company =
            around.any_near(i, limits.surely_far, [&](std::uint32_t j, float squared) {
              return squared < limits.surely_near || closer(points[grid.id[i]], points[grid.id[j]]);
            });
        if (company) at_risk[grid.id[i]] = 1;
      }
    }
  });
}

}  // namespace beespace::core
