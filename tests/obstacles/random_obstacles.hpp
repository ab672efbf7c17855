// Obstacles of all kinds and sizes, at random.
#pragma once

#include "scenes/random_stream.hpp"
#include "tests/obstacles/outlines.hpp"

#include <beespace/obstacle.hpp>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace beespace::test {

inline constexpr double kEndless = std::numeric_limits<double>::infinity();

inline Point random_place(scenes::RandomStream& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

// With both ends, one, or none.
inline Heights random_heights(scenes::RandomStream& random, double scale) {
  const double low = scale * random.uniform(-6.0, 6.0);
  const double high = low + scale * random.uniform(0.1, 6.0);
  switch (random.index(6)) {
    case 0:
      return {};
    case 1:
      return {low, kEndless};
    case 2:
      return {-kEndless, high};
    default:
      return {low, high};
  }
}

// About `scale` times ten large, and as far from `middle` at most. `kind` as in Obstacle.
inline Obstacle random_obstacle(scenes::RandomStream& random, std::size_t kind, double scale,
                                const Point& middle = {}) {
  const Point off = random_place(random, 3.0 * scale);
  const Point at{middle.x + off.x, middle.y + off.y, middle.z + off.z};
  // Now and then of no size at all.
  const auto size = [&] { return random.index(10) == 0 ? 0.0 : scale * random.uniform(0.0, 6.0); };
  Heights heights = random_heights(random, scale);
  heights.low_m += middle.z;
  heights.high_m += middle.z;
  switch (kind) {
    case 0:
      return Sphere{at, size()};
    case 1:
      return Box{at, {at.x + size(), at.y + size(), at.z + size()}};
    case 2:
      return Ground{at.z};
    case 3:
      return UprightCylinder{at.x, at.y, size(), heights};
    default:
      return UprightPrism{moved(random_outline(random), scale, {at.x, at.y}), heights};
  }
}

inline constexpr std::size_t kKinds = 5;

inline std::vector<Obstacle> random_obstacles(scenes::RandomStream& random, std::size_t count,
                                              double spread) {
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < count; ++i) {
    // One ground or two are enough: everything is below the highest.
    std::size_t kind = random.index(kKinds);
    if (kind == 2 && random.index(50) != 0) kind = 4;
    obstacles.push_back(random_obstacle(random, kind, std::exp(random.uniform(-2.0, 1.0)),
                                        random_place(random, spread)));
  }
  return obstacles;
}

}  // namespace beespace::test
