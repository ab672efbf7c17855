// An obstacle that has been checked, ready to be asked how far it is.
#pragma once

#include "base/vector3.hpp"
#include "obstacles/outline.hpp"

#include <beespace/obstacle.hpp>

#include <limits>
#include <variant>

namespace beespace::obstacles {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

using core::Vector3;
using core::vector_of;

struct Prism {
  Outline outline;
  Heights heights;
};

using Solid = std::variant<Sphere, Box, Ground, UprightCylinder, Prism>;

// `obstacle` is a good one (see validate.hpp).
Solid solid_of(const Obstacle& obstacle);

// Where a solid is nearest to a place, and which way is straight out: from that point to the place,
// or from the place to it where it lies inside. The normal has length 1, and is right to a few
// roundings however near the place is to the surface: no difference of nearly equal places.
struct Facing {
  NearestSurface surface;
  Vector3 normal;
};

// Of a place whose coordinates are not larger than the motion domain.
Facing facing_of(const Solid& solid, const Vector3& place);

// Of the numbers that places of its surface are computed from, if they may be far from these.
double size_of(const Solid& solid);

// What the solid lies in, on each axis from `low` to `high`; infinite where it has no end. No
// place of its surface is ever computed to lie outside.
struct Extent {
  Vector3 low;
  Vector3 high;
};
Extent extent_of(const Solid& solid);

}  // namespace beespace::obstacles
