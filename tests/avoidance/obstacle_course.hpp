// Flocks among obstacles, and the clearance of each bee: sampled, in long doubles, with code that
// the library does not have.
#pragma once

#include "tests/avoidance/flock.hpp"
#include "tests/obstacles/random_obstacles.hpp"
#include "tests/obstacles/surface_oracle.hpp"
#include "tests/verify/curve_oracle.hpp"

#include <beespace/obstacle.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::test {

inline ObstacleMap map_of(std::vector<Obstacle> obstacles) {
  auto map = ObstacleMap::of(std::move(obstacles));
  EXPECT_TRUE(map) << map.error().message;
  return map ? *map : ObstacleMap();
}

// The flock's options refer to the map, so a course is not moved.
struct Course {
  Flock flock;
  ObstacleMap map;

  Course() { flock.options.obstacles = &map; }
  Course(const Course&) = delete;
  Course& operator=(const Course&) = delete;
};

inline double clearance_at(const ObstacleMap& map, const Point& place) {
  Real least = std::numeric_limits<Real>::infinity();
  for (const Obstacle& obstacle : map.obstacles()) {
    least = std::min(least, true_distance(obstacle, place));
  }
  return static_cast<double>(least);
}

// A lower limit of the distance along a segment, exceeded by at most a twentieth of its length.
inline double clearance_along(const ObstacleMap& map, const LongSegment& way) {
  constexpr int kPieces = 16;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kPieces; ++k) {
    const LongVector at = way.from + way.way * (static_cast<long double>(k) / kPieces);
    least = std::min(least, clearance_at(map, {static_cast<double>(at.x), static_cast<double>(at.y),
                                               static_cast<double>(at.z)}));
  }
  return least - 0.5 / kPieces * static_cast<double>(length(way.way));
}

// Sampled along the step that a bee flies.
inline double clearance_in_step(const ObstacleMap& map, Mover from, const Mover& to, bool at_once,
                                double step_s, int samples) {
  if (at_once) from.velocity = to.velocity;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= samples; ++k) {
    const std::array<long double, 3> at =
        place_at(from, to, step_s, static_cast<long double>(k) / static_cast<long double>(samples));
    least =
        std::min(least, clearance_at(map, {static_cast<double>(at[0]), static_cast<double>(at[1]),
                                           static_cast<double>(at[2])}));
  }
  return least;
}

// A bee that does not keep the clearance as it flies stands; one that does not even then is
// removed.
inline void leave_the_clear_ones(Course& course) {
  Flock& flock = course.flock;
  const double enough_m = flock.options.clearance_m * 1.0001;
  std::vector<Mover> movers;
  std::vector<FlightLimits> limits;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    if (clearance_along(course.map, flock.stopping_segment(bee)) < enough_m) {
      flock.movers[bee].velocity = {};
      if (clearance_along(course.map, flock.stopping_segment(bee)) < enough_m) continue;
    }
    movers.push_back(flock.movers[bee]);
    limits.push_back(flock.limits[bee]);
  }
  flock.movers = movers;
  flock.limits = limits;
}

// A place at most so far from the obstacle's surface, inside or outside.
inline Point place_near(const Obstacle& obstacle, double far_m, scenes::RandomStream& random) {
  const Point start = test::random_place(random, 20.0 * far_m);
  const auto surface = nearest_surface(obstacle, start);
  EXPECT_TRUE(surface);
  const auto [x, y, z] = scenes::random_direction(random);
  const double by = far_m * random.uniform();
  const Point& p = surface->point;
  return {p.x + by * x, p.y + by * y, p.z + by * z};
}

// A random flock among obstacles of all kinds, whose size is of the order of the bees' distances.
// It keeps the threshold and the clearance.
inline void make_course(Course& course, std::size_t most, std::uint64_t seed) {
  course.flock = random_flock(most, seed);
  Flock& flock = course.flock;
  flock.options.obstacles = &course.map;
  scenes::RandomStream random(seed ^ 0x0B57AC1Eu);
  const double threshold_m = flock.options.threshold_m;
  flock.options.clearance_m = threshold_m * log_uniform(random, 0.05, 1.0);
  std::vector<Obstacle> obstacles;
  const std::size_t count = 3 + random.index(8);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Mover& mover : flock.movers) lowest = std::min(lowest, mover.position.z);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t kind = random.index(kKinds);
    if (kind == 2) {
      obstacles.emplace_back(Ground{lowest + threshold_m * random.uniform(-0.5, 0.5)});
      continue;
    }
    const Point& near =
        flock.movers[random.index(static_cast<std::uint32_t>(flock.size()))].position;
    obstacles.push_back(
        random_obstacle(random, kind, threshold_m * log_uniform(random, 0.02, 0.7), near));
  }
  course.map = map_of(std::move(obstacles));
  leave_the_clear_ones(course);
}

}  // namespace beespace::test
