// When a ball that flies straight gets to a convex piece.
#pragma once

#include "obstacles/convex_piece.hpp"

#include <optional>

namespace beespace::obstacles {

struct Flight {
  Vector3 from;
  Vector3 velocity;
  double radius = 0.0;
};

// The first time up to `horizon` at which the piece is no farther away than the radius; sooner by
// rounding, never later. Of one that passes by within rounding, perhaps when it does.
std::optional<double> first_contact(const ConvexPiece& piece, const Flight& flight, double horizon);

}  // namespace beespace::obstacles
