// The doubles at a threshold: of all that a coordinate may be, the last that is too close.
#pragma once

#include "tests/differential/whole_numbers.hpp"

#include <beespace/point.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace beespace::differential {

// Doubles in their order, as integers: one apart where no other double lies between.
inline std::int64_t rank_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}
inline double double_of(std::int64_t rank) {
  return std::bit_cast<double>(rank < 0 ? std::numeric_limits<std::int64_t>::min() - rank : rank);
}
// So many doubles further up.
inline double ulps_up(double value, int count) {
  return double_of(rank_of(value) + count);
}

// Whether |x|^2 + |y|^2 + |z|^2 < threshold^2 for the real differences of p and q.
inline bool is_closer(const Point& p, const Point& q, double threshold) {
  Unit unit;
  for (const double value : {p.x, p.y, p.z, q.x, q.y, q.z, threshold}) unit.include(value);
  const int u = unit.exponent();
  return squared(whole(p.x, u) - whole(q.x, u)) + squared(whole(p.y, u) - whole(q.y, u)) +
             squared(whole(p.z, u) - whole(q.z, u)) <
         squared(whole(threshold, u));
}

// The x farthest from p's, above it or below it, at which q is still closer to p than the
// threshold; p's own where there is none.
inline double last_closer_x(const Point& p, Point q, double threshold, bool above) {
  q.x = p.x;
  if (!is_closer(p, q, threshold)) return p.x;
  std::int64_t near = rank_of(p.x);
  std::int64_t far = rank_of(p.x + (above ? 2.0 : -2.0) * threshold) + (above ? 2 : -2);
  while (near + (above ? 1 : -1) != far) {
    const std::int64_t middle = std::midpoint(near, far);  // rounds towards near
    q.x = double_of(middle);
    (is_closer(p, q, threshold) ? near : far) = middle;
  }
  return double_of(near);
}

}  // namespace beespace::differential
