// Unit vectors in the arithmetic of avoidance, evenly spread over all directions.
#pragma once

#include "base/vector3.hpp"
#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"

namespace beespace::avoidance {

inline Vector3 direction(scenes::RandomStream& random) {
  return core::vector_of(scenes::random_direction(random));
}

}  // namespace beespace::avoidance
