#include "exact/exact_distance.hpp"

#include "exact/expansion.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace beespace::core {

namespace {

// 2 squared distances of 3 axes, 3 products each, 2 components a product. Exact: in the coordinate
// domain every double is a multiple of 2^-452, so are the components of differences, and products
// are multiples of 2^-904.
using DistanceSum = Expansion<36>;

void add_squared_distance(DistanceSum& sum, const Point& p, const Point& q, double sign) {
  sum.add_squared_difference(p.x, q.x, sign);
  sum.add_squared_difference(p.y, q.y, sign);
  sum.add_squared_difference(p.z, q.z, sign);
}

}  // namespace

int compare_exactly(const Point& p, const Point& q, double distance) {
  DistanceSum difference;
  add_squared_distance(difference, p, q, 1.0);
  difference.add_product(-distance, distance);
  return difference.sign();
}

int compare_distances(const Point& p, const Point& q, const Point& r, const Point& s) {
  const double first = squared_distance(p, q);
  const double second = squared_distance(r, s);
  if (first < second * (1.0 - 0x1p-49)) return -1;  // 5 u + 5 u + 1 u < 16 u
  if (first > second * (1.0 + 0x1p-49)) return 1;
  DistanceSum difference;
  add_squared_distance(difference, p, q, 1.0);
  add_squared_distance(difference, r, s, -1.0);
  return difference.sign();
}

}  // namespace beespace::core
