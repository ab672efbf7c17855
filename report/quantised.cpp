#include "report/quantised.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace beespace::report {

Quantised quantised(std::span<const Point> positions, unsigned bits) {
  constexpr std::array<double Point::*, 3> kAxes = {&Point::x, &Point::y, &Point::z};
  const double most = static_cast<double>((1u << bits) - 1u);
  Quantised result;
  double squared_m2 = 0.0;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const auto along = [&](const Point& p) { return p.*kAxes[axis]; };
    double low = positions.empty() ? 0.0 : along(positions.front());
    double high = low;
    for (const Point& p : positions) {
      low = std::min(low, along(p));
      high = std::max(high, along(p));
    }
    const double step = (high - low) / most;
    result.low_m[axis] = low;
    result.step_m[axis] = step;
    result.codes[axis].reserve(positions.size());
    double farthest = 0.0;
    for (const Point& p : positions) {
      const double code = step > 0.0 ? std::round((along(p) - low) / step) : 0.0;
      result.codes[axis].push_back(static_cast<std::uint16_t>(std::min(code, most)));
      farthest = std::max(farthest, std::abs(low + step * std::min(code, most) - along(p)));
    }
    squared_m2 += farthest * farthest;
  }
  result.error_m = std::sqrt(squared_m2);
  return result;
}

}  // namespace beespace::report
