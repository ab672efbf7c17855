// The order in which many queries are answered: neighbours after each other, so that the caches
// hold what the query before needed.
#pragma once

#include "base/bounds.hpp"

#include <beespace/crew.hpp>
#include <beespace/points_view.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::search {

struct OrderedPlaces {
  std::vector<Point> places;
  std::vector<std::uint32_t> index;  // which of the caller's places each is

  [[nodiscard]] std::size_t size() const { return index.size(); }
};

// The places along a Morton curve through their box. Cost: some ten nanoseconds a place. Nothing
// but speed depends on the order.
OrderedPlaces place_order(const PointsView& places, const core::Bounds& bounds, Crew& crew);

}  // namespace beespace::search
