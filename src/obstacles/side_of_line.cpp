#include "obstacles/side_of_line.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace beespace::obstacles {

namespace {

// A sum of doubles without rounding: components of growing magnitude that do not overlap, so the
// last one carries the sign. Source: J. R. Shewchuk, Adaptive precision floating-point arithmetic
// and fast robust geometric predicates, 1997 (grow-expansion with zero elimination).
class Sum {
 public:
  // Adds a * b. Exact: in the motion domain every double is a multiple of 2^-152, so products and
  // what they round off are multiples of 2^-304.
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  [[nodiscard]] int sign() const {
    if (size_ == 0) return 0;
    return components_[size_ - 1] > 0.0 ? 1 : -1;
  }

 private:
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

  std::array<double, 12> components_{};  // 6 products, 2 components each
  std::size_t size_ = 0;
};

// (a - c) x (b - c) = a x b - a x c - c x b, as c x c is zero.
int exact_side(const Corner& a, const Corner& b, const Corner& c) {
  Sum area;
  area.add_product(a.x, b.y);
  area.add_product(-a.y, b.x);
  area.add_product(-a.x, c.y);
  area.add_product(a.y, c.x);
  area.add_product(-c.x, b.y);
  area.add_product(c.y, b.x);
  return area.sign();
}

}  // namespace

int side_of_line(const Corner& from, const Corner& to, const Corner& point) {
  const double left = (from.x - point.x) * (to.y - point.y);
  const double right = (from.y - point.y) * (to.x - point.x);
  const double area = left - right;
  // Two differences and a product round on either side, 3 u, and the last difference: below 8 u of
  // the sum of the magnitudes, with u = 2^-53.
  const double doubt = 0x1p-50 * (std::abs(left) + std::abs(right));
  if (area > doubt) return 1;
  if (area < -doubt) return -1;
  return exact_side(from, to, point);
}

}  // namespace beespace::obstacles
