// Directions and velocities that are the same on every machine.
//
// No sine and no cosine, whose last bits differ between libraries: a place in the unit ball is
// drawn until one is found, and brought to length 1 by operations that round alike everywhere.
#pragma once

#include "scenes/moving_scenes.hpp"
#include "scenes/random_stream.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cmath>

namespace beespace::scenes {

// Of length 1 but for rounding, every direction alike. Draws six numbers on average.
inline Point random_direction(RandomStream& random) {
  // Near the centre the quotient would show the grid that the numbers lie on; every shell of the
  // ball has all directions alike, so that leaving a smaller ball out changes nothing.
  constexpr double kLeast = 0x1p-8;
  while (true) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    const double z = random.uniform(-1.0, 1.0);
    const double squared = x * x + y * y + z * z;
    if (squared < kLeast || squared > 1.0) continue;
    const double length = std::sqrt(squared);
    return {x / length, y / length, z / length};
  }
}

inline double random_speed(const Speeds& speeds, RandomStream& random) {
  return random.uniform(speeds.slowest_mps, speeds.fastest_mps);
}

inline Velocity along(const Point& direction, double speed_mps) {
  return {direction.x * speed_mps, direction.y * speed_mps, direction.z * speed_mps};
}

inline Velocity random_velocity(const Speeds& speeds, RandomStream& random) {
  const Point direction = random_direction(random);
  return along(direction, random_speed(speeds, random));
}

}  // namespace beespace::scenes
