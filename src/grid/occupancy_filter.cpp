#include "grid/occupancy_filter.hpp"

#include "base/buffer.hpp"
#include "base/hash.hpp"
#include "base/point_block.hpp"
#include "grid/position_block.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <numeric>

namespace beespace::core {

namespace {

constexpr std::uint64_t kSlotsAPoint = 16;

// The set of cells that hold points, by their hashes: membership may be wrong where it says yes,
// never where it says no. Works on blocks of points in short loops without branches, so that many
// table look-ups are under way at once.
class OccupiedCells {
 public:
  OccupiedCells(const Lattice& lattice, double bound, std::size_t size, Memory& memory)
      : fraction_bits_(lattice.fraction_bits()),
        // Positions are cut to whole units: 1 unit for each of two points.
        reach_(static_cast<std::int32_t>(bound * lattice.units_per_m()) + 2),
        mask_(std::bit_ceil(size * kSlotsAPoint) - 1),
        words_(memory, mask_ / kSlotsAWord + 1) {
    std::fill_n(words_.data(), mask_ / kSlotsAWord + 1, std::uint64_t{0});
  }

  // With few units a cell, a point may be near both faces of it: the filter cannot decide then.
  [[nodiscard]] bool is_useful() const { return 2 * reach_ < 1 << fraction_bits_; }

  // Safe to call from several threads at once: which bits are set does not depend on the order.
  void add(const PositionBlock& positions, std::size_t count) {
    std::array<std::uint64_t, PointBlock::kSize> slots;
    for (std::size_t i = 0; i < count; ++i) slots[i] = looked_up(sum_of(positions, i));
    for (std::size_t i = 0; i < count; ++i) {
      const std::atomic_ref<std::uint64_t> word(words_[slots[i] / kSlotsAWord]);
      const std::uint64_t once = kOnce << slots[i] % kSlotsAWord * 2;
      const std::uint64_t before = word.fetch_or(once, std::memory_order_relaxed);
      if ((before & once) != 0) word.fetch_or(once << 1, std::memory_order_relaxed);
    }
  }

  // Sets company[i] when another point may lie within the bound of point i of the block.
  void find_company(const PositionBlock& positions, std::size_t count,
                    std::array<bool, PointBlock::kSize>& company) const {
    struct LookUp {
      std::uint64_t slot;
      std::size_t point;
    };
    std::array<std::uint64_t, PointBlock::kSize> own;
    std::array<LookUp, 7 * PointBlock::kSize> beside;
    std::size_t look_ups = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t sum = sum_of(positions, i);
      own[i] = looked_up(sum);
      std::array<std::uint64_t, 3> step;
      const unsigned faces = near_faces(positions, i, step);
      const auto look_up_if = [&](bool needed, std::uint64_t other) {
        beside[look_ups] = {slot_of(other), i};
        look_ups += needed ? 1 : 0;
      };
      look_up_if((faces & 1) != 0, sum + step[0]);
      look_up_if((faces & 2) != 0, sum + step[1]);
      look_up_if((faces & 4) != 0, sum + step[2]);
      if ((faces & (faces - 1)) != 0) {  // near an edge or a corner: one in six
        look_up_if((faces & 3) == 3, sum + step[0] + step[1]);
        look_up_if((faces & 5) == 5, sum + step[0] + step[2]);
        look_up_if((faces & 6) == 6, sum + step[1] + step[2]);
        look_up_if(faces == 7, sum + step[0] + step[1] + step[2]);
      }
    }
    for (std::size_t i = 0; i < look_ups; ++i) __builtin_prefetch(&word_of(beside[i].slot));
    for (std::size_t i = 0; i < count; ++i) company[i] = holds(own[i], kTwice);
    for (std::size_t i = 0; i < look_ups; ++i) {
      company[beside[i].point] |= holds(beside[i].slot, kOnce);
    }
  }

 private:
  // Two bits a slot: a point is there, another one is there too.
  static constexpr std::uint64_t kSlotsAWord = 32;
  static constexpr std::uint64_t kOnce = 1;
  static constexpr std::uint64_t kTwice = 2;

  [[nodiscard]] std::uint64_t sum_of(const PositionBlock& positions, std::size_t i) const {
    const auto cell = [&](std::size_t axis) {
      return static_cast<std::uint64_t>(positions[axis][i] >> fraction_bits_);
    };
    return cell_sum(cell(0), cell(1), cell(2));
  }
  // One bit an axis for the faces within the bound, and the terms to hash across them.
  [[nodiscard]] unsigned near_faces(const PositionBlock& positions, std::size_t i,
                                    std::array<std::uint64_t, 3>& step) const {
    unsigned faces = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const std::int32_t within = positions[axis][i] & ((1 << fraction_bits_) - 1);
      const bool low = within < reach_;
      const bool high = within + reach_ >= 1 << fraction_bits_;
      step[axis] = low ? 0 - kCellStep[axis] : kCellStep[axis];
      faces |= static_cast<unsigned>(low | high) << axis;
    }
    return faces;
  }
  [[nodiscard]] std::uint64_t slot_of(std::uint64_t sum) const {
    return hash_cell_sum(sum) >> 16 & mask_;
  }
  [[nodiscard]] const std::uint64_t& word_of(std::uint64_t slot) const {
    return words_[slot / kSlotsAWord];
  }
  [[nodiscard]] std::uint64_t looked_up(std::uint64_t sum) const {
    const std::uint64_t slot = slot_of(sum);
    __builtin_prefetch(&word_of(slot));
    return slot;
  }
  [[nodiscard]] bool holds(std::uint64_t slot, std::uint64_t state) const {
    return (word_of(slot) >> slot % kSlotsAWord * 2 & state) != 0;
  }

  unsigned fraction_bits_;
  std::int32_t reach_;
  std::uint64_t mask_;
  Buffer<std::uint64_t> words_;
};

}  // namespace

Vector<PointId> occupancy_filter(const PointsView& points, const Lattice& lattice, double bound,
                                 const Resources& with) {
  OccupiedCells cells(lattice, bound, points.size(), with.memory);
  PerWorker<PointId> left(with);
  if (!cells.is_useful()) {
    left[0].resize(points.size());
    std::iota(left[0].begin(), left[0].end(), PointId{0});
    return std::move(left[0]);
  }
  with.crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for_each_position_block({points}, lattice, begin, end,
                            [&](const PositionBlock& positions, std::size_t, std::size_t count) {
                              cells.add(positions, count);
                            });
  });
  with.crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::array<bool, PointBlock::kSize> company;
    for_each_position_block(
        {points}, lattice, begin, end,
        [&](const PositionBlock& positions, std::size_t first, std::size_t count) {
          cells.find_company(positions, count, company);
          for (std::size_t i = 0; i < count; ++i) {
            if (company[i]) left[worker].push_back(static_cast<PointId>(first + i));
          }
        });
  });
  return std::move(left).joined();
}

}  // namespace beespace::core
