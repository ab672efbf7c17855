// Sums of squared distances, far more precise than doubles, at a fraction of what exact ones cost.
#pragma once

#include <beespace/point.hpp>

#include <cmath>

namespace beespace::core {

// A sum of squared distances as two doubles, the second of which is what the first has lost; right
// to 2^-98 of `size`, the sum of all squares, whatever their signs.
//   Of an axis, the difference is exactly high + low with |low| <= u |high|, u = 2^-53. The square
// of high is exactly two doubles; twice high low is rounded, by 2 u^2 high^2, and low^2 is left
// out, another u^2 high^2. What is lost by high parts is kept, at most 6 u of the size in all; each
// of the dozen roundings of its sum is below 6 u^2 of it. Together less than 2^7 u^2. (In the
// domain, products are multiples of 2^-904.)
class TwoDoubles {
 public:
  void add_squared_distance(const Point& p, const Point& q, double sign) {
    add_squared_difference(p.x, q.x, sign);
    add_squared_difference(p.y, q.y, sign);
    add_squared_difference(p.z, q.z, sign);
  }
  void add_square(double value, double sign) {
    const double square = value * value;
    add(sign * square, sign * std::fma(value, value, -square));
    size_ += square;
  }

  // The sum, rounded once more, and that size.
  [[nodiscard]] double value() const { return high_ + low_; }
  [[nodiscard]] double size() const { return size_; }

  // 0 where that is open.
  [[nodiscard]] int sign() const {
    const double sum = high_ + low_;
    if (std::abs(sum) <= 0x1p-98 * size_) return 0;
    return sum > 0.0 ? 1 : -1;
  }

 private:
  void add_squared_difference(double a, double b, double sign) {
    const double high = a - b;
    const double virtual_b = a - high;
    const double low = (a - (high + virtual_b)) + (virtual_b - b);
    add_square(high, sign);
    low_ += sign * 2.0 * high * low;
  }
  void add(double term, double lost) {
    const double sum = high_ + term;
    const double virtual_term = sum - high_;
    low_ += ((high_ - (sum - virtual_term)) + (term - virtual_term)) + lost;
    high_ = sum;
  }

  double high_ = 0.0;
  double low_ = 0.0;
  double size_ = 0.0;
};

}  // namespace beespace::core
