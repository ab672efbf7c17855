// The queries of an index: at its points, between them, beside them, and from far away.
#pragma once

#include "tests/support/search_scenes.hpp"
#include "tree/point_tree.hpp"

#include <beespace/index.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace beespace::test {

inline Index built(const std::vector<Point>& points, unsigned threads = 1) {
  return Index::build(points, threads).value();
}

inline core::PointTree tree_of(const std::vector<Point>& points, Crew& crew,
                               const PointId* ids = nullptr) {
  core::Memory memory;
  return core::PointTree(points, ids, core::measure(points, {crew, memory}).value(), crew);
}

// The coordinate, or the next that an index takes.
inline double in_domain(double coordinate) {
  if (std::abs(coordinate) < kSmallestCoordinate_m) return 0.0;
  return std::clamp(coordinate, -kLargestCoordinate_m, kLargestCoordinate_m);
}

inline std::vector<Point> places_around(const SearchScene& scene, std::size_t at_most) {
  std::vector<Point> places{{0, 0, 0}, {1e30, -1e30, 1e30}, {-0x1p+399, 0x1p+399, 0}};
  const std::vector<Point>& points = scene.points;
  const std::size_t step = 1 + points.size() / at_most;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Point& p = points[i];
    const Point& q = points[(i * 7 + 1) % points.size()];
    places.push_back(p);
    places.push_back(
        {in_domain(p.x / 2 + q.x / 2), in_domain(p.y / 2 + q.y / 2), in_domain(p.z / 2 + q.z / 2)});
    places.push_back({in_domain(p.x + scene.threshold_m), p.y, in_domain(p.z - scene.threshold_m)});
  }
  return places;
}

}  // namespace beespace::test
