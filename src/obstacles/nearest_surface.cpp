#include "obstacles/solid.hpp"
#include "obstacles/validate.hpp"

#include <beespace/obstacle.hpp>

namespace beespace {

Result<NearestSurface> nearest_surface(const Obstacle& obstacle, const Point& point) {
  if (auto error = obstacles::check(obstacle)) return *std::move(error);
  if (auto error = obstacles::check(point)) return *std::move(error);
  return facing_of(obstacles::solid_of(obstacle), core::vector_of(point)).surface;
}

}  // namespace beespace
