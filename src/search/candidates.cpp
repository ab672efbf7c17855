#include "search/candidates.hpp"

#include "grid/lattice.hpp"
#include "grid/occupancy_filter.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace beespace::search {

namespace {

// Wider, more points share a cell; narrower, more of them are near a face of theirs.
constexpr double kCellInThresholds = 8.0;
// So that no axis of the table is too long.
constexpr double kCellInBox = 0x1p-19;

// A pass costs a fifth of what it may spare. One that leaves out less than one in eight points, and
// no long stretch of space, is the last.
constexpr unsigned kMostPasses = 4;
constexpr std::size_t kWorthIt = 8;
constexpr double kShrinks = 16.0;
// A search takes up to 40 bytes a point. With its copy of those that are left it must not take
// more.
constexpr double kMostLeft = 9.0 / 16.0;

double longest_side(const core::Bounds& box) {
  double longest = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    longest = std::max(longest, box.high[axis] - box.low[axis]);
  }
  return longest;
}

}  // namespace

std::optional<Candidates> Candidates::of(const SearchDomain& domain, double threshold_m,
                                         const core::Resources& with,
                                         const TuningOverrides& tuning) {
  if (domain.has_others()) return std::nullopt;
  const double long_axis = threshold_m * static_cast<double>(tuning.fold_beyond_cells);
  if (domain.widest() < long_axis) return std::nullopt;
  Candidates left(domain.original_bounds(), with.memory);
  bool has_left_out = left.leave_out(domain.original_points(), threshold_m, with);
  if (!has_left_out) return std::nullopt;
  for (unsigned pass = 1; pass < kMostPasses && has_left_out; ++pass) {
    if (left.size() == 0 || longest_side(left.bounds_) < long_axis) break;
    has_left_out = left.leave_out(left.view(), threshold_m, with);
  }
  return left;
}

// Whether that was worth it; else nothing is left out.
bool Candidates::leave_out(const PointsView& points, double threshold_m,
                           const core::Resources& with) {
  const double side = longest_side(bounds_);
  const core::Lattice lattice(std::span(&points, 1), bounds_,
                              std::max(kCellInThresholds * threshold_m, kCellInBox * side),
                              with.memory);
  core::Vector<PointId> left = core::occupancy_filter(points, lattice, threshold_m, with);
  if (ids_.empty() &&
      static_cast<double>(left.size()) > kMostLeft * static_cast<double>(points.size())) {
    return false;
  }
  core::Buffer<Point> places(with.memory, left.size());
  with.crew.split(left.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) places[i] = points[left[i]];
  });
  const core::Bounds box =
      *core::measure(PointsView(std::span<const Point>(places.data(), left.size())), with);
  const bool few = left.size() < points.size() - points.size() / kWorthIt;
  if (!few && longest_side(box) * kShrinks > side) return false;
  if (!ids_.empty()) {
    for (PointId& id : left) id = ids_[id];
  }
  ids_ = std::move(left);
  points_ = std::move(places);
  bounds_ = box;
  return true;
}

PointsView Candidates::view() const {
  return PointsView(std::span<const Point>(points_.data(), ids_.size()));
}

}  // namespace beespace::search
