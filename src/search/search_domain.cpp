#include "search/search_domain.hpp"

#include "exact/validate.hpp"

#include <algorithm>

namespace beespace::search {

namespace {

// About as many are worth having ahead of a point in its row: with fewer, more points lie beside
// seams; with more, more far points are compared. Between 10 and 18 it makes little difference.
constexpr double kExpectedNeighbors = 12.0;

using Order = std::array<std::size_t, 3>;

template <class Element>
std::array<Element, 3> permuted(const std::array<Element, 3>& values, const Order& order) {
  return {values[order[0]], values[order[1]], values[order[2]]};
}

double extent(const core::Bounds& bounds, std::size_t axis) {
  return bounds.high[axis] - bounds.low[axis];
}

// Rows run along the axis with the longest extent: fewer, longer rows.
Order longest_first(const core::Bounds& bounds) {
  Order order{0, 1, 2};
  const auto longer = [&](std::size_t a, std::size_t b) {
    return extent(bounds, a) > extent(bounds, b);
  };
  // Three comparisons, in which equal axes keep their order.
  if (longer(order[1], order[0])) std::swap(order[0], order[1]);
  if (longer(order[2], order[1])) std::swap(order[1], order[2]);
  if (longer(order[1], order[0])) std::swap(order[0], order[1]);
  return order;
}

Result<core::Bounds> measured(const PointsView& points, const char* name,
                              const core::Resources& with) {
  if (auto error = core::check_size(points)) {
    error->location.array = name;
    return *std::move(error);
  }
  Result<core::Bounds> bounds = core::measure(points, with);
  if (!bounds) bounds.error().location.array = name;
  return bounds;
}

}  // namespace

SearchDomain::SearchDomain(std::array<PointsView, 2> sets, std::size_t set_count,
                           const core::Bounds& bounds, const core::Resources& with)
    : originals_(sets),
      order_(longest_first(bounds)),
      sets_(sets),
      set_count_(set_count),
      bounds_(bounds),
      sample_(others(), with.memory),
      neighbors_side_(0.0) {
  for (PointsView& set : sets_) set = turned(set);
  bounds_ = {permuted(bounds.low, order_), permuted(bounds.high, order_)};
  neighbors_side_ = sample_.side_for(kExpectedNeighbors, bounds_);
}

PointsView SearchDomain::turned(const PointsView& points) const {
  return points.with_axes(order_);
}

Result<SearchDomain> SearchDomain::of(const PointsView& points, const core::Resources& with) {
  const Result<core::Bounds> bounds = measured(points, core::kPointsName, with);
  if (!bounds) return bounds.error();
  return of(points, *bounds, with);
}

Result<SearchDomain> SearchDomain::of(const PointsView& points, const PointsView& others,
                                      const core::Resources& with) {
  const Result<core::Bounds> first = measured(points, core::kPointsName, with);
  if (!first) return first.error();
  const Result<core::Bounds> second = measured(others, core::kOthersName, with);
  if (!second) return second.error();
  core::Bounds both = points.empty() ? *second : *first;
  for (std::size_t axis = 0; axis < 3 && !others.empty(); ++axis) {
    both.low[axis] = std::min(both.low[axis], second->low[axis]);
    both.high[axis] = std::max(both.high[axis], second->high[axis]);
  }
  return SearchDomain({points, others}, 2, both, with);
}

double SearchDomain::expected_neighbors(double side_m) const {
  // Far below the side that holds some, only a crowd that the sample has met would show.
  return sample_.expected_neighbors(side_m);
}

bool SearchDomain::is_patchy() const {
  // A cell of an even swarm holds a hundred times as many others as the side says, at least one of
  // the sample in most cells. More than a quarter of the points apart would be too many for grids.
  constexpr double kCellInSides = 4.5;
  constexpr double kMany = 0.3;
  if (neighbors_side_ <= 0.0) return false;
  return sample_.share_apart(has_others() ? &points() : nullptr, kCellInSides * neighbors_side_,
                             widest()) > kMany;
}

core::Bounds SearchDomain::original_bounds() const {
  core::Bounds bounds;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bounds.low[order_[axis]] = bounds_.low[axis];
    bounds.high[order_[axis]] = bounds_.high[axis];
  }
  return bounds;
}

unsigned SearchDomain::row_shift(const core::Lattice& lattice, double reach) const {
  constexpr double kMostInWindow = 1.5 * kExpectedNeighbors;
  const unsigned most = 30 - lattice.fraction_bits();
  const double widest = std::max(extent(bounds_, 1), extent(bounds_, 2));
  const auto share = [&](std::size_t axis, double width) {
    const double across = extent(bounds_, axis);
    const double own = std::min(neighbors_side_, across);
    return own > 0.0 ? std::min(width, across) / own : 1.0;
  };
  const double ahead = neighbors_side_ > 0.0 ? reach / neighbors_side_ : 1.0;
  unsigned shift = 0;
  for (double width = 2.0 * reach; shift < most && width < 2.0 * widest; width *= 2.0) {
    if (kExpectedNeighbors * ahead * share(1, width) * share(2, width) > kMostInWindow) break;
    ++shift;
  }
  return shift;
}

}  // namespace beespace::search
