#include "core/exact_distance.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace beespace::core {

namespace {

// A sum of doubles without rounding: components of growing magnitude that do not overlap, so the
// last one carries the sign. Source: J. R. Shewchuk, Adaptive precision floating-point arithmetic
// and fast robust geometric predicates, 1997 (grow-expansion with zero elimination).
//
// Exact as long as no product underflows: in the coordinate domain every double is a multiple of
// 2^-452, so are the components of differences, and products are multiples of 2^-904.
class Expansion {
 public:
  void add(double term) {
    std::size_t kept = 0;
    double sum = term;
    for (std::size_t i = 0; i < size_; ++i) {
      const double before = sum;
      sum = before + components_[i];
      const double virtual_part = sum - before;
      const double error = (before - (sum - virtual_part)) + (components_[i] - virtual_part);
      if (error != 0.0) components_[kept++] = error;
    }
    if (sum != 0.0) components_[kept++] = sum;
    size_ = kept;
  }

  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  // Adds sign * (a - b)^2.
  void add_squared_difference(double a, double b, double sign) {
    const double high = a - b;
    const double virtual_b = a - high;
    const double low = (a - (high + virtual_b)) + (virtual_b - b);
    if (low != 0.0) {
      add_product(sign * low, low);
      add_product(sign * 2.0 * high, low);
    }
    add_product(sign * high, high);
  }

  [[nodiscard]] int sign() const {
    if (size_ == 0) return 0;
    return components_[size_ - 1] > 0.0 ? 1 : -1;
  }

 private:
  // 2 squared distances of 3 axes, 3 products each, 2 components a product.
  std::array<double, 36> components_{};
  std::size_t size_ = 0;
};

void add_squared_distance(Expansion& sum, const Point& p, const Point& q, double sign) {
  sum.add_squared_difference(p.x, q.x, sign);
  sum.add_squared_difference(p.y, q.y, sign);
  sum.add_squared_difference(p.z, q.z, sign);
}

}  // namespace

int compare_exactly(const Point& p, const Point& q, double distance) {
  Expansion difference;
  add_squared_distance(difference, p, q, 1.0);
  difference.add_product(-distance, distance);
  return difference.sign();
}

int compare_distances(const Point& p, const Point& q, const Point& r, const Point& s) {
  const double first = squared_distance(p, q);
  const double second = squared_distance(r, s);
  if (first < second * (1.0 - 0x1p-49)) return -1;  // 5 u + 5 u + 1 u < 16 u
  if (first > second * (1.0 + 0x1p-49)) return 1;
  Expansion difference;
  add_squared_distance(difference, p, q, 1.0);
  add_squared_distance(difference, r, s, -1.0);
  return difference.sign();
}

}  // namespace beespace::core
