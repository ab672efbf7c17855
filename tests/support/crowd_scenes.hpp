// Scenes with crowds, clumps and duplicates: what ruins a search that expects points to be spread.
#pragma once

#include "tests/support/lattice_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <cmath>
#include <vector>

namespace beespace::test {

inline std::vector<Point> clump_and_lonely_rest(SceneMaker& make) {
  std::vector<Point> points = make.box(240, {0, 0, 0}, {1, 1, 1});
  append(points, make.box(50, {-4, -4, -4}, {4, 4, 4}));
  append(points, make.box(250, {-300, -300, -300}, {300, 300, 300}));
  return points;
}

inline std::vector<Point> clusters(SceneMaker& make) {
  std::vector<Point> points;
  for (const Point& centre : make.box(30, {0, 0, 0}, {1e5, 1e5, 1e5})) {
    append(points, moved(make.box(30, {-60, -60, -60}, {60, 60, 60}), centre));
  }
  return points;
}

inline std::vector<Point> half_of_them_twice(SceneMaker& make) {
  std::vector<Point> points = make.box(200, {0, 0, 0}, {500, 500, 500});
  const std::vector<Point> again(points.begin(), points.begin() + 100);
  append(points, again);
  return points;
}

// 30 places, 12 points at each, in no order.
inline std::vector<Point> crowded_places(SceneMaker& make) {
  std::vector<Point> points;
  for (const Point& place : make.box(30, {0, 0, 0}, {50, 50, 50})) {
    points.insert(points.end(), 12, place);
  }
  make.shuffle(points);
  return points;
}

// A crowd at one place, and others around it at the threshold and one ulp either side: within reach
// of all of the crowd or of none.
inline std::vector<Point> crowd_with_a_rim(double threshold) {
  std::vector<Point> points(60, Point{0, 0, 0});
  for (const double distance :
       {std::nextafter(threshold, 0.0), threshold, std::nextafter(threshold, 2.0 * threshold)}) {
    for (const double side : {-distance, distance}) {
      points.push_back({side, 0, 0});
      points.push_back({0, side, 0});
      points.push_back({0, 0, side});
    }
  }
  points.insert(points.end(), 60, Point{0, 0, 0});
  return points;
}

// Two crowds, each at one place, exactly the threshold apart.
inline std::vector<Point> two_crowds(const Point& apart) {
  std::vector<Point> points;
  for (int i = 0; i < 70; ++i) {
    points.push_back({1, 2, 3});
    points.push_back(shifted({1, 2, 3}, apart));
  }
  return points;
}

// Clumps around the sizes in which kernels take points: 8, 16, 32 and 64, one less and one more.
inline std::vector<Point> clumps_of_every_size(SceneMaker& make, double threshold) {
  std::vector<Point> points;
  double place = 0.0;
  for (const std::size_t size :
       {1U, 2U, 3U, 4U, 7U, 8U, 9U, 15U, 16U, 17U, 31U, 32U, 33U, 63U, 64U, 65U}) {
    const double side = 0.9 * threshold;
    append(points, moved(make.ragged_box(size, {0, 0, 0}, {side, side, side}), {place, 0, -place}));
    place += 6.0 * threshold;
  }
  make.shuffle(points);
  return points;
}

// A little of everything at once.
inline std::vector<Point> mixture(SceneMaker& make) {
  std::vector<Point> points = integer_lattice(5, 1.0, {0, 0, 0});
  append(points, turned(integer_lattice(4, 1.0, {2, 2, 2}), 5, 1, 2, 3));
  append(points, make.ragged_box(80, {-10, -10, -10}, {10, 10, 10}));
  append(points, make.box(30, {2, 2, 2}, {2.01, 2.01, 2.01}));
  append(points, row_of_points(30, 1.0, {0, 0, -1}));
  points.insert(points.end(), 12, Point{-3, -3, -3});
  append(points, make.box(5, {-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6}));
  make.shuffle(points);
  return points;
}

inline std::vector<SearchScene> crowd_scenes() {
  SceneMaker make(11);
  std::vector<SearchScene> scenes;
  const auto add = [&](const char* name, std::vector<Point> points, double threshold) {
    scenes.push_back({name, std::move(points), threshold});
  };
  add("OneDenseCell", make.box(260, {0, 0, 0}, {1, 1, 1}), 100.0);
  add("ThresholdAboveTheBox", make.box(180, {-5, -5, -5}, {5, 5, 5}), 1e6);
  add("Duplicates", half_of_them_twice(make), 0.25);
  add("CrowdedPlaces", crowded_places(make), 10.0);
  add("AllAtOnePlace", std::vector<Point>(230, Point{7, -7, 7}), 0.5);
  add("DenseClumpAndLonelyRest", clump_and_lonely_rest(make), 2.0);
  add("Clusters", clusters(make), 20.0);
  add("CrowdWithARim", crowd_with_a_rim(100.0), 100.0);
  add("CrowdWithARimOfATenth", crowd_with_a_rim(0.1), 0.1);
  add("TwoCrowdsAtTheThreshold", two_crowds({3, 4, 12}), 13.0);
  add("ClumpsOfEverySize", clumps_of_every_size(make, 5.0), 5.0);
  add("Mixture", mixture(make), 1.0);
  return scenes;
}

}  // namespace beespace::test
