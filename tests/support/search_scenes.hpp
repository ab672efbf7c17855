// The scenes that every search is held against brute force on: small, nasty, and named.
#pragma once

#include <beespace/point.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace beespace::test {

struct SearchScene {
  std::string name;
  std::vector<Point> points;
  double threshold_m = 100.0;
};

class SceneMaker {
 public:
  explicit SceneMaker(std::uint32_t seed) : random_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }

  std::vector<Point> box(std::size_t size, const Point& low, const Point& high) {
    std::vector<Point> points(size);
    for (Point& p : points) {
      p = {between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
    }
    return points;
  }

 private:
  std::mt19937 random_;
};

// Pairs at exactly the threshold and one ulp either side, on every axis and along the diagonal of
// a 3-4-12-13 box, each pair far from the others.
inline std::vector<Point> pairs_around_threshold(double threshold) {
  const double below = std::nextafter(threshold, 0.0);
  const double above = std::nextafter(threshold, 2.0 * threshold);
  std::vector<Point> points;
  double place = 0.0;
  const auto add = [&](const Point& offset) {
    place += 16.0 * threshold;
    points.push_back({0.0, place, 0.0});
    points.push_back({offset.x, place + offset.y, offset.z});
  };
  for (const double distance : {below, threshold, above}) {
    add({distance, 0.0, 0.0});
    add({-distance, 0.0, 0.0});
    add({0.0, 0.0, distance});
  }
  const double unit = threshold / 13.0;
  for (const double z :
       {std::nextafter(12.0 * unit, 0.0), 12.0 * unit, std::nextafter(12.0 * unit, threshold)}) {
    add({3.0 * unit, 4.0 * unit, z});
  }
  return points;
}

inline std::vector<Point> integer_lattice(int side, double step, const Point& origin) {
  std::vector<Point> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) {
        points.push_back({origin.x + x * step, origin.y + y * step, origin.z + z * step});
      }
    }
  }
  return points;
}

inline std::vector<SearchScene> search_scenes() {
  SceneMaker make(20240607);
  std::vector<SearchScene> scenes;
  const auto add = [&](std::string name, std::vector<Point> points, double threshold) {
    scenes.push_back({std::move(name), std::move(points), threshold});
  };
  add("Empty", {}, 1.0);
  add("OnePoint", {{1, 2, 3}}, 1.0);
  add("TwoAtTheSamePlace", {{1, 2, 3}, {1, 2, 3}}, 1e-9);
  add("MinusZeroIsZero", {{0.0, 0.0, 0.0}, {-0.0, -0.0, -0.0}, {5, 5, 5}}, 1e-9);
  add("Line", make.box(700, {0, 0, 0}, {3000, 0, 0}), 2.0);
  add("PlaneOfConstantHeight", make.box(900, {0, 0, 120}, {900, 900, 120}), 15.0);
  add("OneDenseCell", make.box(500, {0, 0, 0}, {1, 1, 1}), 100.0);
  add("ThresholdAboveTheBox", make.box(300, {-5, -5, -5}, {5, 5, 5}), 1e6);
  add("UniformFewNeighbours", make.box(1500, {0, 0, 0}, {1000, 1000, 1000}), 40.0);
  add("UniformTwoNeighbours", make.box(1500, {0, 0, 0}, {1000, 1000, 1000}), 68.0);
  add("UniformManyNeighbours", make.box(1500, {0, 0, 0}, {1000, 1000, 1000}), 250.0);
  add("NegativeAndFar", make.box(800, {-6.4e6, -6.4e6, -6.4e6}, {-6.3e6, -6.3e6, -6.3e6}), 4000.0);
  add(
      "Duplicates",
      [&] {
        std::vector<Point> points = make.box(200, {0, 0, 0}, {500, 500, 500});
        const std::vector<Point> again(points.begin(), points.begin() + 100);
        points.insert(points.end(), again.begin(), again.end());
        return points;
      }(),
      0.25);
  add("AllAtOnePlace", std::vector<Point>(400, Point{7, -7, 7}), 0.5);
  add(
      "DenseClumpAndLonelyRest",
      [&] {
        std::vector<Point> points = make.box(600, {0, 0, 0}, {1, 1, 1});
        for (const Point& p : make.box(60, {-4, -4, -4}, {4, 4, 4})) points.push_back(p);
        for (const Point& p : make.box(300, {-300, -300, -300}, {300, 300, 300}))
          points.push_back(p);
        return points;
      }(),
      2.0);
  add(
      "Clusters",
      [&] {
        std::vector<Point> points;
        for (const Point& c : make.box(30, {0, 0, 0}, {1e5, 1e5, 1e5})) {
          for (const Point& p : make.box(40, {-60, -60, -60}, {60, 60, 60})) {
            points.push_back({c.x + p.x, c.y + p.y, c.z + p.z});
          }
        }
        return points;
      }(),
      20.0);
  add("AtTheThresholdOnePointZero", pairs_around_threshold(1.0), 1.0);
  add("AtTheThresholdOneHundred", pairs_around_threshold(100.0), 100.0);
  add("AtTheThresholdOneThird", pairs_around_threshold(1.0 / 3.0), 1.0 / 3.0);
  add("LatticeAtTheThreshold", integer_lattice(9, 1.0, {0, 0, 0}), 1.0);
  add("LatticeAtItsDiagonal", integer_lattice(8, 1.0, {0, 0, 0}), std::sqrt(2.0));
  add("LatticeFarFromTheOrigin", integer_lattice(8, 0.1, {1e9, -1e9, 1e9}), 0.1);
  add("TinyCoordinates", integer_lattice(6, 0x1p-399, {0, 0, 0}), 0x1p-399);
  add("HugeCoordinates", integer_lattice(6, 0x1p+397, {-0x1p+399, 0, 0}), 0x1p+397);
  add(
      "ABillionMetresApart",
      [&] {
        std::vector<Point> points = make.box(300, {-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9});
        for (const Point& p : std::vector<Point>(points.begin(), points.begin() + 40)) {
          points.push_back({p.x + make.between(-1, 1), p.y, p.z});
        }
        return points;
      }(),
      1.0);
  add(
      "OutlierFarBeyondTheSwarm",
      [&] {
        std::vector<Point> points = make.box(700, {0, 0, 0}, {50, 50, 50});
        points.push_back({1e12 * 5, -1e12 * 5, 1e12 * 5});
        return points;
      }(),
      5.0);
  add(
      "OutliersAtEveryScale",
      [&] {
        std::vector<Point> points = make.box(300, {0, 0, 0}, {30, 30, 30});
        for (int power = 2; power < 100; power += 3) {
          const double far = std::ldexp(1.0, power);
          points.push_back({far, -far, 2 * far});
          points.push_back({far, -far, std::nextafter(2 * far, 0.0)});
        }
        return points;
      }(),
      4.0);
  return scenes;
}

}  // namespace beespace::test
