// A scene, and the random numbers that scenes are made of.
//
// Every compiler, optimisation level and machine makes the same scenes, bit for bit: no library
// distribution, no sine, only arithmetic that IEEE 754 rounds in one way.
#pragma once

#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
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

  // One of 0 ... count - 1.
  std::size_t below(std::size_t count) { return random_() % count; }

  std::vector<Point> box(std::size_t size, const Point& low, const Point& high) {
    std::vector<Point> points(size);
    for (Point& p : points) {
      p = {between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
    }
    return points;
  }

  // Coordinates with bits all over: differences of them do not come out round.
  std::vector<Point> ragged_box(std::size_t size, const Point& low, const Point& high) {
    std::vector<Point> points = box(size, low, high);
    for (Point& p : points) {
      p.x += between(0.0, 0x1p-30) * (high.x - low.x);
      p.y += between(0.0, 0x1p-30) * (high.y - low.y);
      p.z += between(0.0, 0x1p-30) * (high.z - low.z);
    }
    return points;
  }

  void shuffle(std::vector<Point>& points) {
    for (std::size_t left = points.size(); left > 1; --left) {
      std::swap(points[left - 1], points[below(left)]);
    }
  }

 private:
  std::mt19937 random_;
};

inline void append(std::vector<Point>& points, const std::vector<Point>& more) {
  points.insert(points.end(), more.begin(), more.end());
}

inline Point shifted(const Point& p, const Point& by) {
  return {p.x + by.x, p.y + by.y, p.z + by.z};
}

}  // namespace beespace::test
