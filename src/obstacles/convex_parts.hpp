// A plane region that is not convex, cut into parts that are.
#pragma once

#include "obstacles/outline.hpp"

#include <vector>

namespace beespace::obstacles {

// Corners are corners of the outline only, so the parts cover the region exactly, and have nothing
// but edges in common. At most four times as many as are needed. Cost, for n corners: n^2 mostly,
// n^3 at worst.
std::vector<Outline> convex_parts(const Outline& outline);

}  // namespace beespace::obstacles
