#include "core/nearest_search.hpp"

#include "core/density.hpp"
#include "core/exact_distance.hpp"
#include "core/hash.hpp"
#include "core/lattice.hpp"
#include "core/look_around.hpp"
#include "core/neighbour_rows.hpp"
#include "core/sorted_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace beespace::core {

namespace {

class NearestSearch {
 public:
  NearestSearch(const PointsView& points, const Bounds& bounds, const SearchOptions& options,
                Crew& crew)
      : points_(points),
        bounds_(bounds),
        options_(options),
        crew_(crew),
        found_(points.size(), Nearest::kNobody),
        squared_(points.size(), std::numeric_limits<double>::infinity()),
        settled_(points.size(), 0) {}

  std::vector<Nearest> run() {
    settle_duplicates();
    std::vector<PointId> open = still_open(0.0);
    double radius = first_radius();
    while (!open.empty()) {
      look_within(radius, open);
      if (radius == options_.threshold_m) break;
      open = still_open(radius);
      // The few who are left in open country may take longer steps.
      const double step = open.size() * 32 < points_.size() ? 4.0 : 2.0;
      radius = std::min(step * radius, options_.threshold_m);
    }
    return finished();
  }

 private:
  void settle_duplicates() {
    const std::size_t slots = std::bit_ceil(points_.size() * 2);
    std::vector<PointId> first_at(slots, Nearest::kNobody);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point p = points_[i];
      std::size_t slot = hash_place(p) & (slots - 1);
      while (first_at[slot] != Nearest::kNobody && points_[first_at[slot]] != p) {
        slot = (slot + 1) & (slots - 1);
      }
      const auto id = static_cast<PointId>(i);
      const PointId first = first_at[slot];
      if (first == Nearest::kNobody) {
        first_at[slot] = id;
        continue;
      }
      settle(id, first);
      if (settled_[first] == 0) settle(first, id);
    }
  }

  void settle(PointId id, PointId twin) {
    found_[id] = twin;
    squared_[id] = 0.0;
    settled_[id] = 1;
  }

  // A radius within which a point has about one neighbour, or the threshold if that is less.
  // Duplicates are mates at any radius, and do not count.
  [[nodiscard]] double first_radius() const {
    constexpr double kTooSmallToMeetByChance = 0x1p-60;
    constexpr int kMostSteps = 64;
    const double twins = mean_cell_mates(points_, options_.threshold_m * kTooSmallToMeetByChance);
    double radius = options_.threshold_m;
    for (int step = 0; step < kMostSteps; ++step) {
      const double mates = mean_cell_mates(points_, radius) - twins;
      if (mates <= 3.0) break;
      radius *= std::max(0.125, std::cbrt(1.0 / mates));
    }
    return std::max(radius, options_.threshold_m * kTooSmallToMeetByChance);
  }

  void look_within(double radius, const std::vector<PointId>& open) {
    const Lattice lattice(points_, bounds_, radius);
    std::vector<PointId> subset;
    if (open.size() * 32 < points_.size()) {
      subset = surroundings(points_, lattice, open, crew_);
    }
    const SortedGrid grid = sort_into_grid(points_, subset, lattice, crew_);
    const SquaredLimits limits(radius, grid.units_per_m);
    crew_.split(grid.rows(), [&](std::size_t begin, std::size_t end, unsigned) {
      NeighbourRows around(grid);
      for (std::size_t row = begin; row < end; ++row) {
        bool selected = false;
        for (std::uint32_t i = grid.row_begin[row]; i < grid.row_begin[row + 1]; ++i) {
          if (settled_[grid.id[i]] != 0) continue;
          if (!selected) around.select(row);
          selected = true;
          float worth_a_look = limits.surely_far;
          around.any_near(i, limits.surely_far, [&](std::uint32_t j, float squared) {
            if (squared > worth_a_look) return false;
            worth_a_look = std::min(worth_a_look, not_surely_farther(squared));
            offer(grid.id[i], grid.id[j]);
            return false;
          });
        }
      }
    });
  }

  // Distances in units are wrong by less than 2 (see SquaredLimits): beyond this squared distance
  // nobody can be nearer than somebody at `squared`.
  static float not_surely_farther(float squared) {
    const float units = std::sqrt(squared) + 4.0F;
    return units * units * (1.0F + 0x1p-18F);
  }

  void offer(PointId to, PointId other) {
    const double squared = squared_distance(points_[to], points_[other]);
    const PointId best = found_[to];
    if (best != Nearest::kNobody) {
      if (squared > squared_[to] * (1.0 + 0x1p-49) || best == other) return;
      const int sign = compare_distances(points_[to], points_[other], points_[to], points_[best]);
      if (sign > 0 || (sign == 0 && other > best)) return;
    }
    found_[to] = other;
    squared_[to] = squared;
  }

  // Whoever has found somebody surely within the radius has found the nearest. The others:
  std::vector<PointId> still_open(double radius) {
    const double surely_within = radius * radius * (1.0 - 0x1p-50);
    std::vector<PointId> open;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (squared_[i] < surely_within) settled_[i] = 1;
      if (settled_[i] == 0) open.push_back(static_cast<PointId>(i));
    }
    return open;
  }

  [[nodiscard]] std::vector<Nearest> finished() const {
    const ProximityTest closer(options_.threshold_m, options_.inclusive);
    std::vector<Nearest> nearest(points_.size());
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      const PointId id = found_[i];
      if (id == Nearest::kNobody || !closer(points_[i], points_[id])) continue;
      nearest[i] = {id, distance(points_[i], points_[id])};
    }
    return nearest;
  }

  const PointsView& points_;
  const Bounds& bounds_;
  const SearchOptions& options_;
  Crew& crew_;
  std::vector<PointId> found_;  // the nearest so far
  std::vector<double> squared_;
  std::vector<std::uint8_t> settled_;
};

}  // namespace

std::vector<Nearest> nearest_within(const PointsView& points, const Bounds& bounds,
                                    const SearchOptions& options, Crew& crew) {
  if (points.size() < 2) return std::vector<Nearest>(points.size());
  return NearestSearch(points, bounds, options, crew).run();
}

}  // namespace beespace::core
