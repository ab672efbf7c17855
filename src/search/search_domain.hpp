// The points of one search, after one pass over them: checked, measured, turned so that rows run
// along the longest axis, and sampled for their density.
#pragma once

#include "base/bounds.hpp"
#include "base/resources.hpp"
#include "grid/density.hpp"
#include "grid/lattice.hpp"

#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace beespace::search {

class SearchDomain {
 public:
  // For one swarm, or for two in a common domain. Errors: as find_at_risk(_between).
  static Result<SearchDomain> of(const PointsView& points, const core::Resources& with);
  static Result<SearchDomain> of(const PointsView& points, const PointsView& others,
                                 const core::Resources& with);
  // For points that have been measured.
  static SearchDomain of(const PointsView& points, const core::Bounds& bounds,
                         const core::Resources& with) {
    return SearchDomain({points, {}}, 1, bounds, with);
  }

  [[nodiscard]] const PointsView& points() const { return sets_[0]; }
  [[nodiscard]] const PointsView& others() const { return sets_[set_count_ - 1]; }
  // The same in the caller's axes, with x first.
  [[nodiscard]] const PointsView& original_points() const { return originals_[0]; }
  [[nodiscard]] const PointsView& original_others() const { return originals_[set_count_ - 1]; }
  // The caller's axis of each of the domain's axes.
  [[nodiscard]] const std::array<std::size_t, 3>& order() const { return order_; }
  [[nodiscard]] bool has_others() const { return set_count_ == 2; }
  [[nodiscard]] std::span<const PointsView> sets() const { return {sets_.data(), set_count_}; }
  [[nodiscard]] const core::Bounds& bounds() const { return bounds_; }
  [[nodiscard]] core::Bounds original_bounds() const;

  // The longest side of the box, and that of a cube that holds about a dozen others.
  [[nodiscard]] double widest() const { return bounds_.high[0] - bounds_.low[0]; }
  [[nodiscard]] double side_with_some() const { return neighbors_side_; }
  // The expected number of others in a cube of side `side_m` around a point's own place.
  [[nodiscard]] double expected_neighbors(double side_m) const;

  // Whether many points are where there are far fewer others than around most of these, or none.
  [[nodiscard]] bool is_patchy() const;

  // The width of rows, as a power of two, for searches up to `reach`: so wide that few points lie
  // beside a seam, and no wider.
  [[nodiscard]] unsigned row_shift(const core::Lattice& lattice, double reach) const;

 private:
  [[nodiscard]] PointsView turned(const PointsView& points) const;
  SearchDomain(std::array<PointsView, 2> sets, std::size_t set_count, const core::Bounds& bounds,
               const core::Resources& with);

  std::array<PointsView, 2> originals_;
  std::array<std::size_t, 3> order_;  // of the axes
  std::array<PointsView, 2> sets_;
  std::size_t set_count_;
  core::Bounds bounds_;
  core::DensitySample sample_;
  double neighbors_side_;  // of a cube that holds about kExpectedNeighbors others
};

}  // namespace beespace::search
