#include "exact/cylinder.hpp"

#include "exact/expansion.hpp"

#include <cmath>

namespace beespace::core {

namespace {

// Of two lines: 3 axes of 3 products each, and the height of 10; 2 components a product.
using CylinderSum = Expansion<76>;

struct Parts {
  double high;
  double low;
};

Parts difference_of(double a, double b) {
  const double high = a - b;
  const double virtual_b = a - high;
  return {high, (a - (high + virtual_b)) + (virtual_b - b)};
}

Parts product_of(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

// Exact: heights are multiples of 2^-452 and units of 2^-72, so the parts are multiples of 2^-524,
// and their products of 2^-1048.
void add_height(CylinderSum& sum, double a, double b, double unit, double sign) {
  const Parts difference = difference_of(a, b);
  const Parts high = product_of(difference.high, unit);
  const Parts low = product_of(difference.low, unit);
  const double parts[] = {high.high, high.low, low.high, low.low};
  for (std::size_t i = 0; i < 4; ++i) {
    if (parts[i] == 0.0) continue;
    sum.add_product(sign * parts[i], parts[i]);
    for (std::size_t j = i + 1; j < 4; ++j) {
      if (parts[j] != 0.0) sum.add_product(sign * 2.0 * parts[i], parts[j]);
    }
  }
}

void add_line(CylinderSum& sum, const Upright& p, const Upright& q, double unit, double sign) {
  for (std::size_t axis = 1; axis < Upright::kAxes; ++axis) {
    sum.add_squared_difference(p.at[axis], q.at[axis], sign);
  }
  add_height(sum, p.height(), q.height(), unit, sign);
}

}  // namespace

int StraightLine::compare(const Upright& p, const Upright& q, const Upright& r,
                          const Upright& s) const {
  const double first = squared(p, q);
  const double second = squared(r, s);
  if (first < second * (1.0 - 0x1p-48)) return -1;  // 9 u + 9 u + 1 u < 32 u
  if (first > second * (1.0 + 0x1p-48)) return 1;
  CylinderSum difference;
  add_line(difference, p, q, unit_, 1.0);
  add_line(difference, r, s, unit_, -1.0);
  return difference.sign();
}

double StraightLine::length(const Upright& p, const Upright& q) const {
  return std::sqrt(squared(p, q));
}

}  // namespace beespace::core
