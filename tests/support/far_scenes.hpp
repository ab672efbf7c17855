// Scenes of extreme extent: far from the origin, far from each other, the ends of the domain.
#pragma once

#include "tests/support/lattice_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <cmath>
#include <vector>

namespace beespace::test {

inline std::vector<Point> close_pairs_a_billion_metres_apart(SceneMaker& make) {
  std::vector<Point> points = make.box(300, {-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9});
  for (std::size_t i = 0; i < 40; ++i) {
    points.push_back(shifted(points[i], {make.between(-1, 1), 0, 0}));
  }
  return points;
}

inline std::vector<Point> outliers_at_every_scale(SceneMaker& make) {
  std::vector<Point> points = make.box(300, {0, 0, 0}, {30, 30, 30});
  for (int power = 2; power < 100; power += 3) {
    const double far = std::ldexp(1.0, power);
    points.push_back({far, -far, 2 * far});
    points.push_back({far, -far, std::nextafter(2 * far, 0.0)});
  }
  return points;
}

// From the smallest coordinate to the largest: at each scale two points one ulp apart, and their
// mirror image.
inline std::vector<Point> whole_domain() {
  std::vector<Point> points;
  for (int power = -400; power <= 400; power += 20) {
    const double far = std::ldexp(1.0, power);
    const double near = std::nextafter(far, power < 0 ? 1.0 : 0.0);
    points.push_back({far, 0, -far});
    points.push_back({near, 0, -far});
    points.push_back({-far, far, 0});
  }
  return points;
}

// Next to the smallest coordinate lie points that differ by less than any coordinate may be.
inline std::vector<Point> finest_lattice() {
  return integer_lattice(6, 0x1p-452, {0x1p-400, 0x1p-400, 0x1p-400});
}

// Thousands of pairs at the threshold, in all directions, where a lattice of many cells an axis has
// few bits left for places within a cell.
inline std::vector<Point> turned_lattice_in_a_coarse_grid(double far) {
  std::vector<Point> points = turned(integer_lattice(7, 1.0, {0, 0, 0}), 2, 3, 4, 5);
  append(points, {{far, 0.1, 0.2}, {0.1, -far, 0.3}, {-0.1, 0.2, far}});
  return points;
}

// Rows of points a threshold apart, from the origin and from so many thresholds further on: where
// the rounding of a place is as large as the difference of two distances.
inline std::vector<Point> rows_far_out(double threshold, int far) {
  std::vector<Point> points;
  for (const Point& axis : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}) {
    for (const int begin : {0, far}) {
      for (int i = begin; i < begin + 45; ++i) {
        points.push_back({i * threshold * axis.x, i * threshold * axis.y, i * threshold * axis.z});
      }
    }
  }
  return points;
}

inline std::vector<Point> swarm_and_outlier(SceneMaker& make, std::size_t size, double side,
                                            const Point& outlier) {
  std::vector<Point> points = make.box(size, {0, 0, 0}, {side, side, side});
  points.push_back(outlier);
  return points;
}

inline std::vector<SearchScene> far_scenes() {
  SceneMaker make(17);
  std::vector<SearchScene> scenes;
  const auto add = [&](const char* name, std::vector<Point> points, double threshold) {
    scenes.push_back({name, std::move(points), threshold});
  };
  add("NegativeAndFar", make.box(800, {-6.4e6, -6.4e6, -6.4e6}, {-6.3e6, -6.3e6, -6.3e6}), 4000.0);
  add("UniformABillionMetresAway", make.box(250, {1e9, -1e9, 1e9}, {1e9 + 99, 99 - 1e9, 1e9 + 99}),
      20.0);
  add("ABillionMetresApart", close_pairs_a_billion_metres_apart(make), 1.0);
  add("TinyCoordinates", integer_lattice(6, 0x1p-399, {0, 0, 0}), 0x1p-399);
  add("HugeCoordinates", integer_lattice(6, 0x1p+397, {-0x1p+399, 0, 0}), 0x1p+397);
  add("FinestDistances", finest_lattice(), 0x1p-400);
  add("WholeDomain", whole_domain(), 1.0);
  add("WholeDomainFinely", whole_domain(), kSmallestCoordinate_m);
  add("WholeDomainCoarsely", whole_domain(), kLargestCoordinate_m);
  add("TurnedLatticeInACoarseGrid", turned_lattice_in_a_coarse_grid(1.5e6), 3.0);
  add("RowsOfThirdsFarOut", rows_far_out(1.0 / 3.0, 900'000), 1.0 / 3.0);
  add("RowsOfTenthsFarOut", rows_far_out(0.1, 900'000), 0.1);
  // The most cells of an axis that is not folded: 2^24.
  add("TurnedLatticeInTheCoarsestGrid", turned_lattice_in_a_coarse_grid(4.9e7), 3.0);
  add("RowsOfTenthsAtTheEndOfTheGrid", rows_far_out(0.1, 16'700'000), 0.1);
  const double far = 5e12;
  add("OutlierFarBeyondTheSwarm", swarm_and_outlier(make, 700, 50.0, {far, -far, far}), 5.0);
  add("ClumpAndOutlier", swarm_and_outlier(make, 200, 1e-3, {-1e9, 0, 1e9}), 1.0);
  add("OutliersAtEveryScale", outliers_at_every_scale(make), 4.0);
  add("LongAlongX", make.ragged_box(200, {0, 0, 0}, {1e6, 3, 3}), 5000.0);
  add("LongAlongY", make.ragged_box(200, {0, 0, 0}, {3, 1e6, 3}), 5000.0);
  add("LongAlongZ", make.ragged_box(200, {0, 0, 0}, {3, 3, 1e6}), 5000.0);
  return scenes;
}

}  // namespace beespace::test
