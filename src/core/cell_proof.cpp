#include "core/cell_proof.hpp"

#include "core/hash.hpp"
#include "core/lattice.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace beespace::core {

namespace {

constexpr std::uint32_t kNoCell = 0xFFFF'FFFFU;

// cell[id] becomes a number that points share exactly when they share a cell; returns how many
// numbers there are at most.
std::uint64_t number_densely(const PointsView& points, const Lattice& lattice, Crew& crew,
                             Buffer<std::uint32_t>& cell) {
  const std::uint64_t row = lattice.cells(0);
  const std::uint64_t layer = row * lattice.cells(1);
  const unsigned shift = lattice.fraction_bits();
  crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      const Point p = points[i];
      cell[i] = static_cast<std::uint32_t>((lattice.position(0, p.x) >> shift) +
                                           (lattice.position(1, p.y) >> shift) * row +
                                           (lattice.position(2, p.z) >> shift) * layer);
    }
  });
  return layer * lattice.cells(2);
}

// Open addressing with whole keys: a hash collision must not prove anything.
std::uint64_t number_by_hashing(const PointsView& points, const Lattice& lattice,
                                Buffer<std::uint32_t>& cell) {
  struct Cell {
    std::uint64_t yz;
    std::uint32_t x;
    std::uint32_t number;
  };
  const std::size_t slots = std::bit_ceil(points.size() + points.size() / 2);
  Buffer<Cell> table(slots);
  std::memset(static_cast<void*>(table.data()), 0xFF, slots * sizeof(Cell));  // number: kNoCell
  std::uint32_t count = 0;
  const unsigned shift = lattice.fraction_bits();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    const auto x = static_cast<std::uint32_t>(lattice.position(0, p.x) >> shift);
    const std::uint64_t y = lattice.position(1, p.y) >> shift;
    const std::uint64_t z = lattice.position(2, p.z) >> shift;
    const std::uint64_t yz = y << 32 | z;
    std::size_t slot = mix(hash_cell(x, y, z)) & (slots - 1);
    while (table[slot].number != kNoCell && (table[slot].yz != yz || table[slot].x != x)) {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot].number == kNoCell) table[slot] = {yz, x, count++};
    cell[i] = table[slot].number;
  }
  return count;
}

// Adds the points [begin, end) to saturating counters: 0, 1, or 2 for "more".
void count_points(const Buffer<std::uint32_t>& cell, std::size_t begin, std::size_t end,
                  std::uint8_t* counters) {
  for (std::size_t i = begin; i < end; ++i) {
    std::uint8_t& counter = counters[cell[i]];
    counter = static_cast<std::uint8_t>(counter + (counter < 2 ? 1 : 0));
  }
}

}  // namespace

double proof_cell_side(double threshold) {
  return threshold / std::sqrt(3.0);
}

std::vector<PointId> prove_by_cells(const PointsView& points, const Bounds& bounds,
                                    double threshold, Crew& crew, Buffer<std::uint8_t>& at_risk,
                                    CellTable table) {
  const std::size_t size = points.size();
  const Lattice lattice(points, bounds, proof_cell_side(threshold) * (1.0 - 0x1p-14));
  // Two points of a cell are less than a cell side apart on each axis, give or take 2^-17 of it:
  // positions have a relative error of 2^-52, and there are less than 2^30 cells.
  const bool proves = lattice.cell_m() <= proof_cell_side(threshold) * (1.0 - 0x1p-16);

  const double cells = static_cast<double>(lattice.cells(0)) *
                       static_cast<double>(lattice.cells(1)) *
                       static_cast<double>(lattice.cells(2));
  const bool dense_fits = cells * crew.size() <= 4.0 * static_cast<double>(size) + 4096.0;
  Buffer<std::uint32_t> cell(size);
  std::uint64_t numbers = 0;
  if (table != CellTable::kHashed && dense_fits) {
    numbers = number_densely(points, lattice, crew, cell);
  } else {
    numbers = number_by_hashing(points, lattice, cell);
  }

  std::vector<std::vector<std::uint8_t>> counters(crew.size());
  crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    counters[worker].resize(numbers);
    count_points(cell, begin, end, counters[worker].data());
  });
  crew.split(numbers, [&](std::size_t begin, std::size_t end, unsigned) {
    for (unsigned worker = 1; worker < crew.size(); ++worker) {
      for (std::size_t i = begin; i < end; ++i) {
        const int sum = counters[0][i] + counters[worker][i];
        counters[0][i] = static_cast<std::uint8_t>(sum < 2 ? sum : 2);
      }
    }
  });

  std::vector<std::vector<PointId>> alone(crew.size());
  const std::uint8_t* total = counters[0].data();
  crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool company = proves && total[cell[i]] >= 2;
      at_risk[i] = company ? 1 : 0;
      if (!company) alone[worker].push_back(static_cast<PointId>(i));
    }
  });
  for (unsigned worker = 1; worker < crew.size(); ++worker) {
    alone[0].insert(alone[0].end(), alone[worker].begin(), alone[worker].end());
  }
  return std::move(alone[0]);
}

}  // namespace beespace::core
