#include "core/sorted_grid.hpp"

#include "core/radix_sort.hpp"

#include <bit>

namespace beespace::core {

namespace {

// Row numbers leave an empty row before and behind those of a layer, so that y - 1 and y + 1 never
// name a row of another layer.
struct Numbering {
  std::uint64_t cells_a_row;
  std::uint64_t rows_a_layer;
  std::uint64_t layers;

  explicit Numbering(const Lattice& lattice)
      : cells_a_row(lattice.cells(0)),
        rows_a_layer(lattice.cells(1) + 2),
        layers(lattice.cells(2)) {}

  // At most 2^31 * (2^31 + 2): fits 63 bits.
  [[nodiscard]] std::uint64_t rows() const { return rows_a_layer * layers; }
  [[nodiscard]] bool fits_narrow() const {
    return rows() <= (std::uint64_t{1} << 32) / cells_a_row;
  }
};

struct CellOf {
  const PointsView& points;
  const Lattice& lattice;
  Numbering numbering;

  [[nodiscard]] std::uint64_t cell(std::size_t axis, PointId id) const {
    return lattice.position(axis, points.coordinate(axis, id)) >> lattice.fraction_bits();
  }
  [[nodiscard]] std::uint64_t row(PointId id) const {
    return cell(2, id) * numbering.rows_a_layer + cell(1, id) + 1;
  }
};

// Cell number and id in one word.
struct NarrowRecord {
  std::uint64_t cell_and_id;

  static NarrowRecord of(PointId id, const CellOf& where) {
    const std::uint64_t cell = where.row(id) * where.numbering.cells_a_row + where.cell(0, id);
    return {cell << 32 | id};
  }
  static unsigned key_bits(const Numbering& numbering) {
    return static_cast<unsigned>(std::bit_width(numbering.rows() * numbering.cells_a_row - 1));
  }
  static auto digit(const Numbering&) {
    return [](const NarrowRecord& record, unsigned shift) {
      return static_cast<std::size_t>(record.cell_and_id >> (32 + shift));
    };
  }
  [[nodiscard]] PointId id() const { return static_cast<PointId>(cell_and_id); }
  [[nodiscard]] std::uint64_t row(const Numbering& numbering) const {
    return (cell_and_id >> 32) / numbering.cells_a_row;
  }
  [[nodiscard]] bool in_row(std::uint64_t row, const Numbering& numbering) const {
    return (cell_and_id >> 32) - row * numbering.cells_a_row < numbering.cells_a_row;
  }
};

// Row and cell apart, for lattices of more than 2^32 cells.
struct WideRecord {
  std::uint64_t row_number;
  std::uint32_t x_cell;
  PointId point;

  static WideRecord of(PointId id, const CellOf& where) {
    return {where.row(id), static_cast<std::uint32_t>(where.cell(0, id)), id};
  }
  static unsigned x_bits(const Numbering& numbering) {
    return static_cast<unsigned>(std::bit_width(numbering.cells_a_row - 1));
  }
  static unsigned key_bits(const Numbering& numbering) {
    return x_bits(numbering) + static_cast<unsigned>(std::bit_width(numbering.rows() - 1));
  }
  static auto digit(const Numbering& numbering) {
    // The key is row_number * 2^x_bits + x_cell; one digit may hold bits of both.
    return [bits = x_bits(numbering)](const WideRecord& record, unsigned shift) {
      if (shift >= bits) return static_cast<std::size_t>(record.row_number >> (shift - bits));
      return static_cast<std::size_t>(record.x_cell >> shift | record.row_number << (bits - shift));
    };
  }
  [[nodiscard]] PointId id() const { return point; }
  [[nodiscard]] std::uint64_t row(const Numbering&) const { return row_number; }
  [[nodiscard]] bool in_row(std::uint64_t row, const Numbering&) const { return row_number == row; }
};

template <class Record>
Buffer<Record> sorted_records(const CellOf& where, std::span<const PointId> subset,
                              std::size_t size, Crew& crew) {
  Buffer<Record> records(size);
  crew.split(size, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      const PointId id = subset.empty() ? static_cast<PointId>(i) : subset[i];
      records[i] = Record::of(id, where);
    }
  });
  Buffer<Record> spare(size);
  radix_sort(records, spare, size, Record::key_bits(where.numbering),
             Record::digit(where.numbering), crew);
  return records;
}

template <class Record>
void find_rows(SortedGrid& grid, const Buffer<Record>& records, const Numbering& numbering) {
  for (std::size_t i = 0; i < grid.size; ++i) {
    if (!grid.row_number.empty() && records[i].in_row(grid.row_number.back(), numbering)) continue;
    grid.row_begin.push_back(static_cast<std::uint32_t>(i));
    grid.row_number.push_back(records[i].row(numbering));
  }
  grid.row_begin.push_back(static_cast<std::uint32_t>(grid.size));
}

template <class Record>
void fill(SortedGrid& grid, const CellOf& where, std::span<const PointId> subset, Crew& crew) {
  const Buffer<Record> records = sorted_records<Record>(where, subset, grid.size, crew);
  find_rows(grid, records, where.numbering);
  const std::size_t padded = grid.size + kPadding;
  grid.x = Buffer<std::int32_t>(padded);
  grid.y = Buffer<std::int32_t>(padded);
  grid.z = Buffer<std::int32_t>(padded);
  grid.id = Buffer<PointId>(padded);
  crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned) {
    const auto units = [&](std::size_t axis, PointId id) {
      const double value = where.points.coordinate(axis, id);
      return static_cast<std::int32_t>(where.lattice.position(axis, value));
    };
    for (std::size_t i = begin; i < end; ++i) {
      const PointId id = records[i].id();
      grid.id[i] = id;
      grid.x[i] = units(0, id);
      grid.y[i] = units(1, id);
      grid.z[i] = units(2, id);
    }
  });
  for (std::size_t i = grid.size; i < padded; ++i) {
    grid.x[i] = grid.y[i] = grid.z[i] = 0;
    grid.id[i] = 0;
  }
}

}  // namespace

SortedGrid sort_into_grid(const PointsView& points, std::span<const PointId> subset,
                          const Lattice& lattice, Crew& crew, KeyWidth width) {
  const CellOf where{points, lattice, Numbering(lattice)};
  SortedGrid grid;
  grid.size = subset.empty() ? points.size() : subset.size();
  grid.fraction_bits = lattice.fraction_bits();
  grid.units_per_m = lattice.units_per_m();
  grid.rows_a_layer = where.numbering.rows_a_layer;
  if (width != KeyWidth::kWide && where.numbering.fits_narrow()) {
    fill<NarrowRecord>(grid, where, subset, crew);
  } else {
    fill<WideRecord>(grid, where, subset, crew);
  }
  return grid;
}

}  // namespace beespace::core
