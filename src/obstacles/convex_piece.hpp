// Obstacles as convex sets: what planes can be put between.
#pragma once

#include "obstacles/solid.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace beespace::obstacles {

// An obstacle that is convex, or a convex part of one that is not.
class ConvexPiece {
 public:
  // `solid` is convex.
  ConvexPiece(Solid solid, std::size_t obstacle) : solid_(std::move(solid)), obstacle_(obstacle) {}

  // Of which obstacle of the map.
  [[nodiscard]] std::size_t obstacle() const { return obstacle_; }
  // What its places are computed to the rounding of (see solid.hpp).
  [[nodiscard]] double size() const { return size_of(solid_); }
  [[nodiscard]] Extent extent() const { return extent_of(solid_); }

  // Where the piece is nearest to a place, and the normal there (see Facing).
  [[nodiscard]] Facing facing(const Vector3& place) const { return facing_of(solid_, place); }

  // The nearest place of the piece; `place` itself inside.
  [[nodiscard]] Vector3 nearest_to(const Vector3& place) const {
    const NearestSurface surface = facing(place).surface;
    return surface.distance_m > 0.0 ? vector_of(surface.point) : place;
  }

  // How far the piece reaches along the normal: the greatest normal . x of its places, infinite
  // where it has no end. Right to the rounding of three products and their sum; so wherever the
  // normal points, all of the piece lies in the half-space normal . x <= support(normal).
  [[nodiscard]] double support(const Vector3& normal) const;

 private:
  Solid solid_;
  std::size_t obstacle_;
};

// The pieces that an obstacle consists of.
void append_pieces(const Solid& solid, std::size_t obstacle, std::vector<ConvexPiece>& pieces);

}  // namespace beespace::obstacles
