#include "core/look_around.hpp"

#include "core/hash.hpp"
#include "core/near_pairs.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace beespace::core {

namespace {

std::uint64_t slot_of(std::uint64_t x, std::uint64_t y, std::uint64_t z, std::uint64_t mask) {
  return (hash_cell(x, y, z) >> 20) & mask;
}

class Looker {
 public:
  Looker(const SortedGrid& grid, const PointsView& points, const ProximityTest& closer,
         double threshold)
      : grid_(grid), points_(points), closer_(closer), limits_(threshold, grid.units_per_m) {}

  // Fills in the rows around `row`; rows must come in ascending order.
  void select(std::size_t row) {
    const std::uint64_t number = grid_.row_number[row];
    // Rows y-1, y, y+1 of the layers below, at and above. Layer 0 has none below.
    for (std::uint64_t layer = 0; layer < 3; ++layer) {
      const std::uint64_t middle = number + layer * grid_.rows_a_layer;
      if (middle < grid_.rows_a_layer + 1) {
        around_[layer] = {0, 0};
        continue;
      }
      const std::uint64_t first = middle - grid_.rows_a_layer - 1;
      cursor_[layer] = grid_.skip_to(first, cursor_[layer]);
      around_[layer] = {cursor_[layer], grid_.skip_to(first + 3, cursor_[layer])};
    }
  }

  // Whether sorted point i of the selected row has company.
  [[nodiscard]] bool has_company(std::uint32_t i) const {
    const std::int32_t cell = grid_.x[i] >> grid_.fraction_bits;
    const std::int32_t first_x = (cell - 1) * (1 << grid_.fraction_bits);
    for (const Rows& rows : around_) {
      for (std::size_t row = rows.begin; row < rows.end; ++row) {
        const std::int32_t* begin = grid_.x + grid_.row_begin[row];
        const std::int32_t* end = grid_.x + grid_.row_begin[row + 1];
        // A row stands in the order of its cells, so this is a valid partition point.
        const std::int32_t* from =
            std::partition_point(begin, end, [=](std::int32_t x) { return x < first_x; });
        if (run_has_company(i, static_cast<std::uint32_t>(from - grid_.x),
                            grid_.row_begin[row + 1])) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  struct Rows {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  [[nodiscard]] bool run_has_company(std::uint32_t i, std::uint32_t from, std::uint32_t end) const {
    const std::int32_t last_cell = (grid_.x[i] >> grid_.fraction_bits) + 1;
    for (std::uint32_t j = from; j < end && grid_.x[j] >> grid_.fraction_bits <= last_cell; ++j) {
      const float squared = squared_units(grid_, i, j);
      if (squared > limits_.surely_far || i == j) continue;
      if (squared < limits_.surely_near || closer_(points_[grid_.id[i]], points_[grid_.id[j]])) {
        return true;
      }
    }
    return false;
  }

  const SortedGrid& grid_;
  const PointsView& points_;
  const ProximityTest& closer_;
  SquaredLimits limits_;
  std::array<Rows, 3> around_{};
  std::array<std::size_t, 3> cursor_{};
};

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
  crew.split(grid.rows(), [&](std::size_t begin, std::size_t end, unsigned) {
    Looker looker(grid, points, closer, threshold);
    for (std::size_t row = begin; row < end; ++row) {
      bool selected = false;
      for (std::uint32_t i = grid.row_begin[row]; i < grid.row_begin[row + 1]; ++i) {
        if (at_risk[grid.id[i]] != 0) continue;
        if (!selected) looker.select(row);
        selected = true;
        if (looker.has_company(i)) at_risk[grid.id[i]] = 1;
      }
    }
  });
}

}  // namespace beespace::core
