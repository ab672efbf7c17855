// Whether an obstacle is one, and a question about it makes sense.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/result.hpp>

#include <optional>

namespace beespace::obstacles {

// Cost, for an outline of n corners: n^2.
std::optional<Error> check(const Obstacle& obstacle);

std::optional<Error> check(const Point& position);
std::optional<Error> check(const Mover& ball, double radius_m, double horizon_s);

}  // namespace beespace::obstacles
