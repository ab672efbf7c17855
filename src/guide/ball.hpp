// A ball around some places: that of the box around them.
#pragma once

#include "base/vector3.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <span>

namespace beespace::guide {

struct Ball {
  core::Vector3 middle;
  double radius_m = 0.0;
};

// `places` is not empty.
inline Ball ball_around(std::span<const Point> places) {
  core::Vector3 low = core::vector_of(places.front());
  core::Vector3 high = low;
  for (const Point& place : places) {
    low = {std::min(low.x, place.x), std::min(low.y, place.y), std::min(low.z, place.z)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y), std::max(high.z, place.z)};
  }
  return {(low + high) * 0.5, 0.5 * length(high - low)};
}

}  // namespace beespace::guide
