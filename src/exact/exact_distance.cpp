#include "exact/exact_distance.hpp"

#include "exact/expansion.hpp"
#include "exact/two_doubles.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

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

// Squares and sums of doubles with few digits, as those of formations are, are often not rounded at
// all. Whether a sum or difference of two is exact: by what each of the two lost in it.
bool is_exact_sum(double a, double b, double sum) {
  const double b_in_sum = sum - a;
  return a - (sum - b_in_sum) == 0.0 && b - b_in_sum == 0.0;
}

// So few digits that the square is exact. (No underflow: in the domain, products are multiples of
// 2^-904.)
bool has_exact_square(double value) {
  constexpr std::uint64_t kLowBits = (std::uint64_t{1} << 27) - 1;
  return (std::bit_cast<std::uint64_t>(value) & kLowBits) == 0;
}

// Whether squared_distance(p, q) is exact.
bool is_exact_square_of_distance(const Point& p, const Point& q) {
  const double dx = p.x - q.x;
  const double dy = p.y - q.y;
  const double dz = p.z - q.z;
  if (!has_exact_square(dx) || !has_exact_square(dy) || !has_exact_square(dz)) return false;
  const double xy = dx * dx + dy * dy;
  return is_exact_sum(p.x, -q.x, dx) && is_exact_sum(p.y, -q.y, dy) &&
         is_exact_sum(p.z, -q.z, dz) && is_exact_sum(dx * dx, dy * dy, xy) &&
         is_exact_sum(xy, dz * dz, xy + dz * dz);
}

int sign_of(double first, double second) {
  return first < second ? -1 : first > second ? 1 : 0;
}

}  // namespace

int compare_exactly(const Point& p, const Point& q, double distance) {
  if (has_exact_square(distance) && is_exact_square_of_distance(p, q)) {
    return sign_of(squared_distance(p, q), distance * distance);
  }
  TwoDoubles probably;
  probably.add_squared_distance(p, q, 1.0);
  probably.add_square(distance, -1.0);
  if (const int sign = probably.sign(); sign != 0) return sign;
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
  if (is_exact_square_of_distance(p, q) && is_exact_square_of_distance(r, s)) {
    return sign_of(first, second);
  }
  TwoDoubles probably;
  probably.add_squared_distance(p, q, 1.0);
  probably.add_squared_distance(r, s, -1.0);
  if (const int sign = probably.sign(); sign != 0) return sign;
  DistanceSum difference;
  add_squared_distance(difference, p, q, 1.0);
  add_squared_distance(difference, r, s, -1.0);
  return difference.sign();
}

}  // namespace beespace::core
