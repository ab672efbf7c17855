#include <beespace/nearest.hpp>

#include "core/bounds.hpp"
#include "core/density.hpp"
#include "core/exact_distance.hpp"
#include "core/lattice.hpp"
#include "core/look_around.hpp"
#include "core/near_pairs.hpp"
#include "core/sorted_grid.hpp"
#include "core/validate.hpp"
#include "cpu/thread_crew.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace beespace {

namespace {

// Looks within a small radius first and doubles it for those who found nobody: in a crowd the
// nearest is near, whatever the threshold.
class NearestSearch {
 public:
  NearestSearch(const PointsView& points, const core::Bounds& bounds, const SearchOptions& options,
                core::Crew& crew)
      : points_(points),
        bounds_(bounds),
        options_(options),
        crew_(crew),
        nearest_(points.size()),
        settled_(points.size(), 0) {}

  std::vector<Nearest> run() {
    std::vector<PointId> open;
    for (double radius = first_radius();; radius = std::min(2.0 * radius, options_.threshold_m)) {
      look_within(radius, open);
      if (radius == options_.threshold_m) break;
      open = settle(radius);
      if (open.empty()) break;
    }
    finish();
    return std::move(nearest_);
  }

 private:
  // A radius within which a point has about one neighbour, or the threshold if that is less.
  [[nodiscard]] double first_radius() const {
    double radius = options_.threshold_m;
    for (int step = 0; step < 64; ++step) {
      const double mates = core::mean_cell_mates(points_, radius);
      if (mates <= 3.0) break;
      radius *= std::max(0.125, std::cbrt(1.0 / mates));
    }
    return radius;
  }

  // `open`: the points that still look for somebody; empty for all.
  void look_within(double radius, const std::vector<PointId>& open) {
    const core::Lattice lattice(points_, bounds_, radius);
    std::vector<PointId> subset;
    if (!open.empty() && open.size() * 32 < points_.size()) {
      subset = core::surroundings(points_, lattice, open, crew_);
    }
    const core::SortedGrid grid = core::sort_into_grid(points_, subset, lattice, crew_);
    const core::SquaredLimits limits(radius, grid.units_per_m);
    core::for_each_near_pair(grid, limits.surely_far, [&](std::uint32_t i, std::uint32_t j, float) {
      const PointId a = grid.id[i];
      const PointId b = grid.id[j];
      if (settled_[a] != 0 && settled_[b] != 0) return;
      const double squared = core::squared_distance(points_[a], points_[b]);
      if (settled_[a] == 0) offer(a, b, squared);
      if (settled_[b] == 0) offer(b, a, squared);
    });
  }

  // Until finish(), distance_m holds the squared distance.
  void offer(PointId to, PointId other, double squared) {
    Nearest& best = nearest_[to];
    if (best.id != Nearest::kNobody) {
      if (squared > best.distance_m * (1.0 + 0x1p-49) || best.id == other) return;
      const int sign =
          core::compare_distances(points_[to], points_[other], points_[to], points_[best.id]);
      if (sign > 0 || (sign == 0 && other > best.id)) return;
    }
    best = {other, squared};
  }

  // Whoever has found somebody surely within the radius has found the nearest. Returns the others.
  std::vector<PointId> settle(double radius) {
    const double surely_within = radius * radius * (1.0 - 0x1p-50);
    std::vector<PointId> open;
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
      if (settled_[i] != 0) continue;
      const bool found =
          nearest_[i].id != Nearest::kNobody && nearest_[i].distance_m < surely_within;
      if (found) settled_[i] = 1;
      if (!found) open.push_back(static_cast<PointId>(i));
    }
    return open;
  }

  void finish() {
    const core::ProximityTest closer(options_.threshold_m, options_.inclusive);
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
      Nearest& found = nearest_[i];
      if (found.id == Nearest::kNobody) continue;
      const Point p = points_[i];
      const Point q = points_[found.id];
      found = closer(p, q) ? Nearest{found.id, distance(p, q)} : Nearest{};
    }
  }

  const PointsView& points_;
  const core::Bounds& bounds_;
  const SearchOptions& options_;
  core::Crew& crew_;
  std::vector<Nearest> nearest_;
  std::vector<std::uint8_t> settled_;
};

}  // namespace

Result<std::vector<Nearest>> find_nearest(const PointsView& points, const SearchOptions& options) {
  if (auto error = core::check_options(options)) return *std::move(error);
  if (auto error = core::check_size(points.size())) return *std::move(error);
  cpu::ThreadCrew crew(cpu::crew_size(options.threads, points.size()));
  const Result<core::Bounds> bounds = core::measure(points, crew);
  if (!bounds) return bounds.error();
  if (points.size() < 2) return std::vector<Nearest>(points.size());
  return NearestSearch(points, *bounds, options, crew).run();
}

}  // namespace beespace
