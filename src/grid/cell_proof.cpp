#include "grid/cell_proof.hpp"

#include "base/hash.hpp"
#include "grid/lattice.hpp"
#include "grid/position_block.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace beespace::core {

namespace {

constexpr PointId kNone = 0xFFFF'FFFFU;

void combine(const PositionBlock& positions, std::size_t count, unsigned shift,
             std::uint32_t row_cells, std::uint32_t layer_cells, std::uint32_t* cell) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t x = static_cast<std::uint32_t>(positions[0][i]) >> shift;
    const std::uint32_t y = static_cast<std::uint32_t>(positions[1][i]) >> shift;
    const std::uint32_t z = static_cast<std::uint32_t>(positions[2][i]) >> shift;
    cell[i] = x + y * row_cells + z * layer_cells;
  }
}

// cell[id] becomes a number that points share exactly when they share a cell; returns how many
// numbers there are at most.
std::uint64_t number_densely(const PointsView& points, const Lattice& lattice,
                             const Resources& with, Buffer<std::uint32_t>& cell) {
  const std::uint64_t row = lattice.cells(0);
  const std::uint64_t layer = row * lattice.cells(1);
  const auto row_cells = static_cast<std::uint32_t>(row);
  const auto layer_cells = static_cast<std::uint32_t>(layer);
  const unsigned shift = lattice.fraction_bits();
  with.crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for_each_position_block(
        {points}, lattice, begin, end,
        [&](const PositionBlock& positions, std::size_t first, std::size_t count) {
          combine(positions, count, shift, row_cells, layer_cells, cell.data() + first);
        });
  });
  return layer * lattice.cells(2);
}

// Open addressing; a slot holds a point of its cell, whose cell is computed again to compare: a
// hash collision must not prove anything.
std::uint64_t number_by_hashing(const PointsView& points, const Lattice& lattice, Memory& memory,
                                Buffer<std::uint32_t>& cell) {
  const auto cell_of = [&](std::size_t id) {
    const Point p = points[id];
    return std::array<std::uint32_t, 3>{lattice.cell(0, p.x), lattice.cell(1, p.y),
                                        lattice.cell(2, p.z)};
  };
  const std::size_t slots = std::bit_ceil(points.size() + points.size() / 2);
  Buffer<PointId> first_in(memory, slots);
  std::fill_n(first_in.data(), slots, kNone);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto own = cell_of(i);
    std::size_t slot = mix(hash_cell(own[0], own[1], own[2])) & (slots - 1);
    while (first_in[slot] != kNone && cell_of(first_in[slot]) != own) {
      slot = (slot + 1) & (slots - 1);
    }
    if (first_in[slot] == kNone) first_in[slot] = static_cast<PointId>(i);
    cell[i] = first_in[slot];
  }
  return points.size();
}

Vector<std::uint8_t> count_points(const Buffer<std::uint32_t>& cell, std::size_t size,
                                  std::size_t numbers, const Resources& with) {
  const auto saturated = [](int count) { return static_cast<std::uint8_t>(count < 2 ? count : 2); };
  PerWorker<std::uint8_t> counts(with);
  with.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    counts[worker].resize(numbers);
    std::uint8_t* mine = counts[worker].data();
    const std::uint32_t* cell_of = cell.data();
    for (std::size_t i = begin; i < end; ++i) mine[cell_of[i]] = saturated(mine[cell_of[i]] + 1);
  });
  with.crew.split(numbers, [&](std::size_t begin, std::size_t end, unsigned) {
    for (unsigned worker = 1; worker < with.crew.size(); ++worker) {
      for (std::size_t i = begin; i < end; ++i) {
        counts[0][i] = saturated(counts[0][i] + counts[worker][i]);
      }
    }
  });
  return std::move(counts[0]);
}

// For every cell the points alone in theirs that may be within the threshold of a point of the
// cell: those at most two cells away on each axis, since the threshold is sqrt(3) cells.
class AloneNearby {
 public:
  static constexpr std::size_t kCellsEach = 125;  // 5 x 5 x 5

  AloneNearby(const Vector<PointId>& alone, const Buffer<std::uint32_t>& cell,
              const Lattice& lattice, std::size_t cells, Memory& memory)
      : first_(cells, kNone, &memory), entries_(&memory) {
    const auto along = [&](std::size_t axis) {
      return static_cast<std::size_t>(lattice.cells(axis));
    };
    const auto clipped = [&](std::size_t axis, std::size_t middle) {
      return std::pair{middle < 2 ? 0 : middle - 2, std::min(middle + 3, along(axis))};
    };
    entries_.reserve(alone.size() * kCellsEach);
    for (const PointId id : alone) {
      const std::size_t own = cell[id];
      const auto [x_begin, x_end] = clipped(0, own % along(0));
      const auto [y_begin, y_end] = clipped(1, own / along(0) % along(1));
      const auto [z_begin, z_end] = clipped(2, own / along(0) / along(1));
      for (std::size_t z = z_begin; z < z_end; ++z) {
        for (std::size_t y = y_begin; y < y_end; ++y) {
          for (std::size_t x = x_begin; x < x_end; ++x) {
            std::uint32_t& first = first_[(z * along(1) + y) * along(0) + x];
            entries_.push_back({id, first});
            first = static_cast<std::uint32_t>(entries_.size() - 1);
          }
        }
      }
    }
  }

  template <class Visit>
  void for_each(std::uint32_t cell, Visit&& visit) const {
    for (std::uint32_t at = first_[cell]; at != kNone; at = entries_[at].next) {
      visit(entries_[at].id);
    }
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFF'FFFFU;
  struct Entry {
    PointId id;
    std::uint32_t next;
  };

  Vector<std::uint32_t> first_;
  Vector<Entry> entries_;
};

// Decides the few points that are alone in their cells: every point is compared with those nearby.
// Most find a neighbour among the first points that come; the lists are made anew for the others,
// so that most points have none to be compared with.
void settle_alone(const PointsView& points, const ProximityTest& closer,
                  const Buffer<std::uint32_t>& cell, const Lattice& lattice, std::size_t cells,
                  Vector<PointId> alone, const Resources& with, Buffer<std::uint8_t>& at_risk) {
  const std::size_t size = points.size();
  std::size_t done = 0;
  for (std::size_t step = size / 64 + 1; done < size && !alone.empty(); step *= 4) {
    const AloneNearby nearby(alone, cell, lattice, cells, with.memory);
    const std::size_t count = std::min(step, size - done);
    with.crew.split(count, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = done + begin; i < done + end; ++i) {
        nearby.for_each(cell[i], [&](PointId id) {
          // Several workers may find a neighbour of the same point; all of them write the same.
          const std::atomic_ref<std::uint8_t> found(at_risk[id]);
          if (found.load(std::memory_order_relaxed) != 0 || id == i) return;
          if (closer(points[i], points[id])) found.store(1, std::memory_order_relaxed);
        });
      }
    });
    done += count;
    std::erase_if(alone, [&](PointId id) { return at_risk[id] != 0; });
  }
}

// Marks the points that share their cell; returns those that are alone.
Vector<PointId> read_off(const Buffer<std::uint32_t>& cell, const Vector<std::uint8_t>& counts,
                         std::size_t size, const Resources& with, Buffer<std::uint8_t>& at_risk) {
  PerWorker<PointId> alone(with);
  with.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    const std::uint32_t* cell_of = cell.data();
    const std::uint8_t* count_in = counts.data();
    std::uint8_t* result = at_risk.data();
    for (std::size_t i = begin; i < end; ++i) {
      const bool company = count_in[cell_of[i]] == 2;
      result[i] = company ? 1 : 0;
      if (!company) [[unlikely]] {
        alone[worker].push_back(static_cast<PointId>(i));
      }
    }
  });
  return std::move(alone).joined();
}

}  // namespace

double proof_cell_side(double threshold) {
  return threshold / std::sqrt(3.0);
}

Vector<PointId> prove_by_cells(const PointsView& points, const Bounds& bounds, double threshold,
                               const ProximityTest& closer, const Resources& with,
                               Buffer<std::uint8_t>& at_risk, CellTable table) {
  const std::size_t size = points.size();
  const Lattice lattice(std::span(&points, 1), bounds, proof_cell_side(threshold) * (1.0 - 0x1p-14),
                        with.memory);
  // Two points of a cell are less than a cell side apart on each axis, give or take 2^-17 of it:
  // positions have a relative error of 2^-52, and there are less than 2^30 cells.
  if (lattice.cell_m() > proof_cell_side(threshold) * (1.0 - 0x1p-16)) {
    Vector<PointId> all(size, &with.memory);
    std::iota(all.begin(), all.end(), PointId{0});
    std::fill_n(at_risk.data(), size, std::uint8_t{0});
    return all;
  }

  const double cells = static_cast<double>(lattice.cells(0)) *
                       static_cast<double>(lattice.cells(1)) *
                       static_cast<double>(lattice.cells(2));
  const bool dense = table != CellTable::kHashed && cells < 4294967295.0 &&
                     cells * with.crew.size() <= 4.0 * static_cast<double>(size) + 4096.0;
  Buffer<std::uint32_t> cell(with.memory, size);
  const std::uint64_t numbers = dense ? number_densely(points, lattice, with, cell)
                                      : number_by_hashing(points, lattice, with.memory, cell);
  // A table a worker; hashed cells are as many as points, and counted by one.
  Crew one;
  const Vector<std::uint8_t> counts =
      count_points(cell, size, numbers, dense ? with : Resources{one, with.memory});
  Vector<PointId> alone = read_off(cell, counts, size, with, at_risk);
  if (dense && !alone.empty() && alone.size() * AloneNearby::kCellsEach <= size / 2) {
    settle_alone(points, closer, cell, lattice, numbers, std::move(alone), with, at_risk);
    return Vector<PointId>(&with.memory);
  }
  return alone;
}

}  // namespace beespace::core
