// The levels of an Index, and a query in them.
#pragma once

#include "index/changing_points.hpp"
#include "kernels/tree_walk.hpp"
#include "tree/nearest_list.hpp"

#include <beespace/crew.hpp>
#include <beespace/index.hpp>

#include <optional>
#include <span>
#include <vector>

namespace beespace {

namespace search {

class IndexLevels {
 public:
  explicit IndexLevels(ChangingPoints held);

  // The ids of the points in the ball, ascending, in the caller's vector.
  void find_around(const cpu::Ball& ball, std::vector<PointId>& found) const;

  // Offers all points to a list that was started at the place.
  void find_nearest(const Point& place, core::NearestList& list) const;

  ChangingPoints points;

 private:
  cpu::TreeWalks walks_;
};

std::optional<Error> check_radius(double radius_m);

// The answers to many queries, all in the domain and in this box. The radii, one for each place,
// take precedence over that of the options, unless there are none.
Result<IdRows> find_around_all(const IndexLevels& levels, const PointsView& places,
                               std::span<const double> radii_m, const core::Bounds& bounds,
                               const AroundOptions& options, Crew& crew);
NearestRows find_nearest_of_all(const IndexLevels& levels, const PointsView& places,
                                const core::Bounds& bounds, std::size_t k, Crew& crew);

}  // namespace search

class Index::Levels final : public search::IndexLevels {
 public:
  using IndexLevels::IndexLevels;

  Crew* lent = nullptr;  // the caller's threads
};

}  // namespace beespace
