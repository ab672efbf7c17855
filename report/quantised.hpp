// Positions in 16 bits an axis, or fewer.
#pragma once

#include <beespace/point.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace beespace::report {

// Position i is low + step * code of i, on each axis.
struct Quantised {
  std::array<std::vector<std::uint16_t>, 3> codes;  // of x, y, z
  std::array<double, 3> low_m = {};
  std::array<double, 3> step_m = {};
  double error_m = 0.0;  // no position is farther than this from where it is told to be
};

// With `bits` (1 to 16) of each code in use. All positions are finite.
Quantised quantised(std::span<const Point> positions, unsigned bits);

}  // namespace beespace::report
