// Checks of missions: the distances of places, and a digest of all their bits.
#pragma once

#include "scenes/missions.hpp"
#include "tests/scenes/fingerprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <variant>
#include <vector>

namespace beespace::scenes {

inline std::uint64_t fingerprint(const Mission& mission) {
  Fingerprint fingerprint;
  for (const std::vector<Point>* points : {&mission.starts, &mission.goals}) {
    for (const auto& [x, y, z] : *points) fingerprint.take({x, y, z});
  }
  for (const Obstacle& obstacle : mission.obstacles) {
    if (const auto* pillar = std::get_if<UprightCylinder>(&obstacle)) {
      fingerprint.take({pillar->x, pillar->y, pillar->radius_m});
    } else if (const auto* ground = std::get_if<Ground>(&obstacle)) {
      fingerprint.take({ground->height_m});
    }
  }
  return fingerprint.value();
}

inline double distance(const Point& p, const Point& q) {
  return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
}

inline double least_distance(const std::vector<Point>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      least = std::min(least, distance(points[i], points[j]));
    }
  }
  return least;
}

inline std::vector<Point> sorted(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  return points;
}

inline void expect_clear(const Mission& mission, std::size_t count, double clear_m) {
  ASSERT_EQ(mission.starts.size(), count);
  ASSERT_EQ(mission.goals.size(), count);
  if (count < 2) return;
  ASSERT_GE(least_distance(mission.starts), clear_m);
  ASSERT_GE(least_distance(mission.goals), clear_m);
}

}  // namespace beespace::scenes
