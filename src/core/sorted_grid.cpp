#include "core/sorted_grid.hpp"

#include "core/cell_sort.hpp"

#include <utility>

namespace beespace::core {

namespace {

void find_rows(SortedGrid& grid, const Buffer<CellRecord>& records, const CellOrder& order) {
  // Counted only where there may be many more or fewer than guessed.
  std::size_t rows = order.rows();
  if (rows > grid.size / 8) {
    rows = 0;
    std::uint64_t last = ~std::uint64_t{0};
    for (std::size_t i = 0; i < grid.size; ++i) {
      const std::uint64_t row = order.row(records[i]);
      if (std::exchange(last, row) != row) ++rows;
    }
  }
  grid.row_begin.reserve(rows + 1);
  grid.row_number.reserve(rows);
  for (std::size_t i = 0; i < grid.size; ++i) {
    const std::uint64_t row = order.row(records[i]);
    if (!grid.row_number.empty() && grid.row_number.back() == row) continue;
    grid.row_begin.push_back(static_cast<std::uint32_t>(i));
    grid.row_number.push_back(row);
  }
  grid.row_begin.push_back(static_cast<std::uint32_t>(grid.size));
}

}  // namespace

SortedGrid sort_into_grid(const PointsView& points, std::span<const PointId> subset,
                          const Lattice& lattice, Crew& crew) {
  const CellOrder order(lattice);
  SortedGrid grid;
  grid.size = subset.empty() ? points.size() : subset.size();
  grid.fraction_bits = lattice.fraction_bits();
  grid.units_per_m = lattice.units_per_m();
  grid.rows_a_layer = order.rows_a_layer();

  SortedCells sorted = sort_by_cell(points, subset, lattice, order, kPadding, crew);
  const Buffer<CellRecord>& records = sorted.records;
  find_rows(grid, records, order);
  const std::size_t padded = grid.size + kPadding;
  static_assert(sizeof(CellRecord) == 4 * sizeof(std::int32_t));
  grid.storage = std::move(sorted.spare).reused_as<std::int32_t>();
  std::int32_t* x = grid.storage.data();
  std::int32_t* y = x + padded;
  std::int32_t* z = y + padded;
  auto* id = reinterpret_cast<PointId*>(z + padded);  // int's unsigned twin may share its memory
  crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      x[i] = records[i].position[0];
      y[i] = records[i].position[1];
      z[i] = records[i].position[2];
      id[i] = records[i].id;
    }
  });
  for (std::size_t i = grid.size; i < padded; ++i) {
    x[i] = y[i] = z[i] = 0;
    id[i] = 0;
  }
  grid.x = x;
  grid.y = y;
  grid.z = z;
  grid.id = id;
  return grid;
}

}  // namespace beespace::core
