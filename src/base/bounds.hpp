// One pass over the points: do they all lie in the coordinate domain, and in which box?
#pragma once

#include "base/resources.hpp"

#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <array>
#include <limits>

namespace beespace::core {

struct Bounds {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
};

// Of nothing: what it is extended by, it becomes.
inline constexpr Bounds kNoBox = {
    {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     std::numeric_limits<double>::infinity()},
    {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
     -std::numeric_limits<double>::infinity()}};

// The box of the points, or the error for the first point outside the coordinate domain.
// All zero for no points.
Result<Bounds> measure(const PointsView& points, const Resources& with);

}  // namespace beespace::core
