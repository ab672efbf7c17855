// The order of places in a CylinderTree: neighbours together.
//
// Only speed depends on it. So it may count widths in thresholds, horizontal or vertical by the
// axis, and may round: no decision is made here.
#pragma once

#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "exact/cylinder.hpp"

#include <array>
#include <cstdint>

namespace beespace::core {

struct CylinderSize {
  double level;    // the horizontal threshold
  double upright;  // the vertical one

  [[nodiscard]] double along(std::size_t axis) const { return axis == 0 ? upright : level; }
};

// Entry s is the index of the point that belongs into slot s. The box of the points is cut into
// cells, half by half, always across the axis that is widest in thresholds. Points that share a
// cell with more than `few` others are ordered in the same way in the box of that cell, unless all
// are at one place. Each time at least the widest axis is cut, and doubles have a limited number of
// binary orders: no input is quadratic. Expected cost: some 20 nanoseconds a point. The order does
// not depend on the number of workers.
Buffer<std::uint32_t> cylinder_order(const UprightPoints& points, const CylinderSize& size,
                                     std::size_t few, const Resources& with);

}  // namespace beespace::core
