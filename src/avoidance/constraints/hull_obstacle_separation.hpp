// The constraint of an obstacle on a claim: as obstacle_separation.hpp, of a hull.
#pragma once

#include "avoidance/constraints/hull_separation.hpp"
#include "avoidance/constraints/obstacle_separation.hpp"
#include "obstacles/convex_piece.hpp"

#include <span>

namespace beespace::avoidance {

// `remembered` are normals that are considered first. Any normal is valid.
ObstacleSeparation separate(const Hull& hull, const obstacles::ConvexPiece& piece,
                            std::span<const Vector3> remembered, double enough_m);

// For an agent that is in an obstacle, and faces its nearest surface.
ObstacleSeparation part_inside(const Hull& hull, const obstacles::Facing& out);

}  // namespace beespace::avoidance
