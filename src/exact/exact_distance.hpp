// Is |p - q| below X, as real numbers? And which of two distances is shorter?
//
// The ladder of every search ends here: a double with a proven error bound decides nearly always,
// an exact expansion decides the rest. Holds in the coordinate domain of point.hpp.
#pragma once

#include <beespace/point.hpp>

#include <cmath>

namespace beespace::core {

// Rounded like doubles; relative error at most 5 u + O(u^2) with u = 2^-53: one rounding in each
// difference (counted twice by the square), one in the square, two in the sums.
inline double squared_distance(const Point& p, const Point& q) {
  const double dx = p.x - q.x;
  const double dy = p.y - q.y;
  const double dz = p.z - q.z;
  return dx * dx + dy * dy + dz * dz;
}

// beespace::distance, for loops.
inline double rounded_distance(const Point& p, const Point& q) {
  return std::sqrt(squared_distance(p, q));
}

// The sign (-1, 0, 1) of |p - q| - distance, exactly. Slow: for what rounding left open.
int compare_exactly(const Point& p, const Point& q, double distance);

// The sign of |p - q| - |r - s|, exactly, filter included.
int compare_distances(const Point& p, const Point& q, const Point& r, const Point& s);

// "Closer than the threshold", decided exactly.
class ProximityTest {
 public:
  ProximityTest(double threshold, bool inclusive)
      : threshold_(threshold),
        inclusive_(inclusive),
        // 5 u from squared_distance, 1 u from this square, 1 u from this product: 7 u < 8 u.
        surely_near_(threshold * threshold * (1.0 - 0x1p-50)),
        surely_far_(threshold * threshold * (1.0 + 0x1p-50)) {}

  [[nodiscard]] bool operator()(const Point& p, const Point& q) const {
    const double squared = squared_distance(p, q);
    if (squared < surely_near_) return true;
    if (squared > surely_far_) return false;
    const int sign = compare_exactly(p, q, threshold_);
    return sign < 0 || (inclusive_ && sign == 0);
  }

 private:
  double threshold_;
  bool inclusive_;
  double surely_near_;
  double surely_far_;
};

}  // namespace beespace::core
