// Rows of points as in sorted grids, and the pairs that a sweep over them must compare: by plain
// double arithmetic, without windows, sides or lanes.
#pragma once

#include "grid/sorted_grid.hpp"
#include "kernels/sweep.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>
#include <random>
#include <vector>

namespace beespace::test {

struct SweepShape {
  bool by_itself = true;
  bool all_rows = false;  // around a set by itself
  unsigned fraction_bits = 10;
  unsigned row_shift = 0;
  std::int32_t cells_along_x = 9;
  std::uint32_t row_size = 20;
  std::int32_t reach_cells = 1;

  [[nodiscard]] std::int32_t cell() const { return 1 << fraction_bits; }
  [[nodiscard]] double squared_reach() const {
    const double reach = static_cast<double>(cell()) * reach_cells;
    return reach * reach;
  }
  [[nodiscard]] std::int32_t row_width() const { return cell() << row_shift; }
  [[nodiscard]] unsigned slice_bits() const { return fraction_bits - std::min(fraction_bits, 2U); }

  friend std::ostream& operator<<(std::ostream& out, const SweepShape& shape) {
    return out << (shape.by_itself ? "by itself" : "between two")
               << (shape.all_rows ? ", all rows" : "") << ", " << shape.row_size
               << " points a row along " << shape.cells_along_x << " cells, row shift "
               << shape.row_shift << ", fraction bits " << shape.fraction_bits << ", reach of "
               << shape.reach_cells;
  }
};

using Spot = std::array<std::int32_t, 3>;

struct PlacedPoints {
  std::array<std::vector<std::int32_t>, 3> at;
  std::vector<PointId> id;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(id.size()); }
  [[nodiscard]] cpu::Positions positions() const {
    return {at[0].data(), at[1].data(), at[2].data(), id.data()};
  }
};

inline double squared_between(const PlacedPoints& a, std::uint32_t i, const PlacedPoints& b,
                              std::uint32_t j) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double difference = a.at[axis][i] - b.at[axis][j];
    sum += difference * difference;
  }
  return sum;
}

// One row of query points, and rows around it. By itself, the row is swept against itself and the
// rows of later numbers, or against all rows; between two sets, against all rows around, the same
// one included.
class SweepScene {
 public:
  explicit SweepScene(const SweepShape& of) : shape(of) {}

  // The asking row, in the middle of 3 x 3 rows. First of all.
  void ask(std::vector<Spot> spots) {
    points = add(asked_, std::move(spots), 100);
    if (shape.by_itself) own = points;
  }

  // The row at place y, z of the 3 x 3. `first_id` names its points.
  void add_target(unsigned y, unsigned z, std::vector<Spot> spots, PointId first_id) {
    using namespace cpu;
    const unsigned in_y[3] = {kLowY, 0, kHighY};
    const unsigned in_z[3] = {kLowZ, 0, kHighZ};
    targets_.push_back(
        {add(shape.by_itself ? asked_ : others_, std::move(spots), first_id), in_y[y] | in_z[z]});
  }

  // Behind the last point its copies, which would be near to it if they counted.
  void pad() {
    size_ = others().size();
    for (PlacedPoints* set : {&asked_, &others_}) {
      for (std::vector<std::int32_t>& axis : set->at) {
        if (!axis.empty()) axis.resize(axis.size() + core::kPadding, axis.back());
      }
      if (!set->id.empty()) set->id.resize(set->id.size() + core::kPadding, set->id.back());
    }
  }

  [[nodiscard]] const PlacedPoints& asked() const { return asked_; }
  [[nodiscard]] const PlacedPoints& others() const { return shape.by_itself ? asked_ : others_; }
  [[nodiscard]] std::uint32_t size() const { return size_; }  // of the others, without padding

  [[nodiscard]] cpu::Sweep sweep(const cpu::Limits& limits, const cpu::Unsure& unsure) const {
    cpu::Sweep sweep{asked().positions(),
                     others().positions(),
                     shape.fraction_bits,
                     shape.row_shift,
                     shape.slice_bits(),
                     shape.reach_cells,
                     limits,
                     same_set,
                     points,
                     own,
                     {},
                     static_cast<unsigned>(targets_.size()),
                     unsure};
    std::copy(targets_.begin(), targets_.end(), sweep.targets);
    return sweep;
  }

  // Calls visit(asked, other, squared distance) for all pairs that the sweep must compare, pairs of
  // the own row once.
  template <class Visit>
  void for_each_pair(Visit&& visit) const {
    for (std::uint32_t i = points.begin; i < points.end; ++i) {
      for (std::uint32_t j = i + 1; j < own.end; ++j) visit(i, j, squared(i, j));
    }
    for_each_pair_across(visit);
  }
  // The same, with pairs of the own row once for each of the two.
  template <class Visit>
  void for_each_pair_of_asked(Visit&& visit) const {
    for (std::uint32_t i = points.begin; i < points.end; ++i) {
      for (std::uint32_t j = own.begin; j < own.end; ++j) {
        if (j != i) visit(i, j, squared(i, j));
      }
    }
    for_each_pair_across(visit);
  }
  template <class Visit>
  void for_each_pair_across(Visit&& visit) const {
    for (std::uint32_t i = points.begin; i < points.end; ++i) {
      for (const cpu::Target& target : targets_) {
        for (std::uint32_t j = target.points.begin; j < target.points.end; ++j) {
          visit(i, j, squared(i, j));
        }
      }
    }
  }
  [[nodiscard]] double squared(std::uint32_t i, std::uint32_t j) const {
    return squared_between(asked(), i, others(), j);
  }

  SweepShape shape;
  cpu::Range points{0, 0};  // the queries: all of the row, or a part of it
  cpu::Range own{0, 0};     // the row, by itself
  bool same_set = true;

 private:
  // In the order of their slices.
  cpu::Range add(PlacedPoints& set, std::vector<Spot> spots, PointId first_id) const {
    const unsigned shift = shape.slice_bits();
    std::stable_sort(spots.begin(), spots.end(), [shift](const Spot& a, const Spot& b) {
      return a[0] >> shift < b[0] >> shift;
    });
    const std::uint32_t begin = set.size();
    for (const Spot& spot : spots) {
      for (std::size_t axis = 0; axis < 3; ++axis) set.at[axis].push_back(spot[axis]);
      set.id.push_back(first_id++);
    }
    return {begin, set.size()};
  }

  PlacedPoints asked_;
  PlacedPoints others_;
  std::vector<cpu::Target> targets_;
  std::uint32_t size_ = 0;
};

// Random points in all rows that there can be. Many lie exactly at faces of cells along x, or a
// unit beside them. Between two sets, the middle row holds the asking points again: the same ids.
inline SweepScene random_sweep_scene(const SweepShape& shape, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](std::int32_t limit) {
    return static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(limit));
  };
  const auto spots_in = [&](unsigned y, unsigned z, std::uint32_t count) {
    std::vector<Spot> spots(count);
    for (Spot& spot : spots) {
      const std::int32_t face = (1 + below(shape.cells_along_x)) * shape.cell() + below(3) - 1;
      spot[0] = below(3) == 0 ? face : below((2 + shape.cells_along_x) * shape.cell());
      spot[1] = static_cast<std::int32_t>(y) * shape.row_width() + below(shape.row_width());
      spot[2] = static_cast<std::int32_t>(z) * shape.row_width() + below(shape.row_width());
    }
    return spots;
  };
  SweepScene scene(shape);
  const std::vector<Spot> own = spots_in(1, 1, shape.row_size);
  scene.ask(own);
  PointId next_id = 10'000;
  for (unsigned z = 0; z < 3; ++z) {
    for (unsigned y = 0; y < 3; ++y) {
      const bool middle = y == 1 && z == 1;
      const bool earlier = 3 * z + y < 5;
      if (shape.by_itself && (shape.all_rows ? middle : earlier)) continue;
      if (middle) {
        scene.add_target(y, z, own, 100);
      } else {
        scene.add_target(y, z, spots_in(y, z, shape.row_size + y), next_id += 10'000);
      }
    }
  }
  scene.pad();
  return scene;
}

}  // namespace beespace::test
