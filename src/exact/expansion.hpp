// A sum of doubles without rounding: components of growing magnitude that do not overlap, so the
// last one carries the sign. Source: J. R. Shewchuk, Adaptive precision floating-point arithmetic
// and fast robust geometric predicates, 1997 (grow-expansion with zero elimination).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace beespace::core {

// Of at most so many components: each term that is added may make one. Exact as long as no product
// underflows, which is for the caller to see to.
template <std::size_t Components>
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

  // Two terms.
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  // Adds sign * (a - b)^2: three products.
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
  std::array<double, Components> components_{};
  std::size_t size_ = 0;
};

}  // namespace beespace::core
