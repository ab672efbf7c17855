#include "core/closest_pair.hpp"

#include "core/bounds.hpp"
#include "core/buffer.hpp"
#include "core/exact_distance.hpp"
#include "core/hash.hpp"
#include "core/lattice.hpp"
#include "core/near_pairs.hpp"
#include "core/point_block.hpp"
#include "core/sorted_grid.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace beespace::core {

namespace {

constexpr std::size_t kFew = 256;           // compared each with each
constexpr std::size_t kRun = 16;            // points that are drawn together
constexpr std::size_t kRunShare = 8;        // one run of so many is drawn
constexpr double kSieveCellInBounds = 8.0;  // wide cells: few of their points are near a face
constexpr std::uint64_t kSieveSlotsAPoint = 16;

// The best pair so far, compared exactly.
class Closest {
 public:
  explicit Closest(const PointsView& points) : points_(points) {}

  void offer(PointId a, PointId b) {
    const double squared = squared_distance(points_[a], points_[b]);
    if (squared > surely_farther_) return;
    const IdPair pair = a < b ? IdPair{a, b} : IdPair{b, a};
    if (found_) {
      const int sign = compare_distances(points_[pair.first], points_[pair.second],
                                         points_[best_.first], points_[best_.second]);
      const bool lower =
          pair.first != best_.first ? pair.first < best_.first : pair.second < best_.second;
      if (sign > 0 || (sign == 0 && !lower)) return;
    }
    best_ = pair;
    found_ = true;
    surely_farther_ = squared * (1.0 + 0x1p-49);  // both carry at most 5 * 2^-53
  }

  [[nodiscard]] IdPair best() const { return best_; }

 private:
  const PointsView& points_;
  IdPair best_{0, 0};
  bool found_ = false;
  double surely_farther_ = std::numeric_limits<double>::infinity();
};

// The lowest pair of points at the same place; there must be one.
IdPair lowest_duplicates(const PointsView& points) {
  constexpr PointId kEmpty = std::numeric_limits<PointId>::max();
  const std::size_t slots = std::bit_ceil(points.size() * 2);
  std::vector<PointId> first_at(slots, kEmpty);
  IdPair lowest{kEmpty, kEmpty};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    std::uint64_t hash = 0;
    for (const double value : {p.x, p.y, p.z}) {
      hash = mix(hash + std::bit_cast<std::uint64_t>(value + 0.0));  // -0 is 0
    }
    std::size_t slot = hash & (slots - 1);
    while (first_at[slot] != kEmpty && points[first_at[slot]] != p) slot = (slot + 1) & (slots - 1);
    const auto id = static_cast<PointId>(i);
    if (first_at[slot] == kEmpty) {
      first_at[slot] = id;
    } else if (first_at[slot] < lowest.first) {
      lowest = {first_at[slot], id};
    }
  }
  return lowest;
}

// Short runs of neighbours in memory: as good as single points for the bound, since a run hides at
// most the pairs within its own stretch of the input, and six times cheaper to read.
std::vector<Point> random_sample(const PointsView& points) {
  constexpr std::size_t kStretch = kRun * kRunShare;
  std::vector<Point> sample;
  sample.reserve(points.size() / kRunShare + kRun);
  for (std::size_t begin = 0; begin + kRun <= points.size(); begin += kStretch) {
    const std::size_t room = std::min(kStretch, points.size() - begin) - kRun + 1;
    const std::size_t first = begin + mix(begin + points.size()) % room;
    for (std::size_t i = first; i < first + kRun; ++i) sample.push_back(points[i]);
  }
  return sample;
}

using BlockPositions = std::array<std::array<std::int32_t, PointBlock::kSize>, 3>;

// Which cells hold points, by their hashes: a set that may say yes too often, never no. Works on
// blocks of points in short loops without branches, so that many table look-ups are under way at
// once.
class Sieve {
 public:
  Sieve(const Lattice& lattice, double bound, std::size_t size)
      : fraction_bits_(lattice.fraction_bits()),
        // Positions are cut to whole units: 1 unit for each of two points.
        reach_(static_cast<std::int32_t>(bound * lattice.units_per_m()) + 2),
        mask_(std::bit_ceil(size * kSieveSlotsAPoint) - 1),
        words_(mask_ / kSlotsAWord + 1) {
    std::fill_n(words_.data(), mask_ / kSlotsAWord + 1, std::uint64_t{0});
  }

  // With few units a cell, a point may be near both faces of it: the sieve cannot tell then.
  [[nodiscard]] bool is_useful() const { return 2 * reach_ < 1 << fraction_bits_; }

  void add(const BlockPositions& positions, std::size_t count) {
    std::array<std::uint64_t, PointBlock::kSize> slots;
    for (std::size_t i = 0; i < count; ++i) slots[i] = looked_up(sum_of(positions, i));
    for (std::size_t i = 0; i < count; ++i) {
      std::uint64_t& word = words_[slots[i] / kSlotsAWord];
      const std::uint64_t once = kOnce << slots[i] % kSlotsAWord * 2;
      word |= once | (word & once) << 1;
    }
  }

  // Sets company[i] when another point may lie within the bound of point i of the block.
  void find_company(const BlockPositions& positions, std::size_t count,
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

  [[nodiscard]] std::uint64_t sum_of(const BlockPositions& positions, std::size_t i) const {
    const auto cell = [&](std::size_t axis) {
      return static_cast<std::uint64_t>(positions[axis][i] >> fraction_bits_);
    };
    return cell_sum(cell(0), cell(1), cell(2));
  }
  // One bit an axis for the faces within the bound, and what it takes to hash across them.
  [[nodiscard]] unsigned near_faces(const BlockPositions& positions, std::size_t i,
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

// Calls visit(positions, first id, count) for [begin, end) in blocks.
template <class Visit>
void for_each_position_block(const PointsView& points, const Lattice& lattice, std::size_t begin,
                             std::size_t end, Visit&& visit) {
  PointBlock block;
  BlockPositions positions;
  for_each_block(begin, end, [&](std::size_t first, std::size_t count) {
    block.load(points, first, count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lattice.positions(axis, block.axis(axis), count, positions[axis].data());
    }
    visit(positions, first, count);
  });
}

// The points that may have company within the bound, ascending.
std::vector<PointId> sieve(const PointsView& points, const Lattice& lattice, double bound,
                           Crew& crew) {
  Sieve cells(lattice, bound, points.size());
  std::vector<std::vector<PointId>> left(crew.size());
  if (!cells.is_useful()) {
    left[0].resize(points.size());
    std::iota(left[0].begin(), left[0].end(), PointId{0});
    return std::move(left[0]);
  }
  for_each_position_block(points, lattice, 0, points.size(),
                          [&](const BlockPositions& positions, std::size_t, std::size_t count) {
                            cells.add(positions, count);
                          });
  crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::array<bool, PointBlock::kSize> company;
    for_each_position_block(
        points, lattice, begin, end,
        [&](const BlockPositions& positions, std::size_t first, std::size_t count) {
          cells.find_company(positions, count, company);
          for (std::size_t i = 0; i < count; ++i) {
            if (company[i]) left[worker].push_back(static_cast<PointId>(first + i));
          }
        });
  });
  for (unsigned worker = 1; worker < crew.size(); ++worker) {
    left[0].insert(left[0].end(), left[worker].begin(), left[worker].end());
  }
  return std::move(left[0]);
}

// The closest pair among points of which two are at most `bound` apart.
IdPair closest_within(const PointsView& points, const Bounds& bounds, double bound, Crew& crew) {
  const Lattice lattice(points, bounds, bound);
  const SortedGrid grid = sort_into_grid(points, {}, lattice, crew);
  const SquaredLimits limits(bound, grid.units_per_m);
  Closest closest(points);
  for_each_near_pair(grid, limits.surely_far, [&](std::uint32_t i, std::uint32_t j, float) {
    closest.offer(grid.id[i], grid.id[j]);
  });
  return closest.best();
}

}  // namespace

IdPair closest_pair(const PointsView& points, const Bounds& bounds, Crew& crew) {
  if (points.size() <= kFew) {
    Closest closest(points);
    const auto size = static_cast<PointId>(points.size());
    for (PointId i = 0; i < size; ++i) {
      for (PointId j = i + 1; j < size; ++j) closest.offer(i, j);
    }
    return closest.best();
  }

  const std::vector<Point> sample = random_sample(points);
  const IdPair near = closest_pair(sample, bounds, crew);
  // Rounded up, so that the pair itself is within the bound.
  const double bound =
      std::sqrt(squared_distance(sample[near.first], sample[near.second])) * (1.0 + 0x1p-40);
  if (bound == 0.0) return lowest_duplicates(points);

  const Lattice lattice(points, bounds, kSieveCellInBounds * bound);
  const std::vector<PointId> left = sieve(points, lattice, bound, crew);
  std::vector<Point> few(left.size());
  for (std::size_t i = 0; i < left.size(); ++i) few[i] = points[left[i]];
  // Ids ascend, so the lowest pair of the few is the lowest pair of all.
  const IdPair pair = closest_within(few, bounds, bound, crew);
  return {left[pair.first], left[pair.second]};
}

}  // namespace beespace::core
