/// @file
/// @brief What must stay free around an agent: a sphere, an ellipsoid or an upright cylinder.
///
/// Two agents lose separation where the offset between their centres lies within the shape. Its
/// horizontal semi-axis is the threshold, or the sum of both radii where that is more. Units:
/// metres, in one Cartesian frame in which z is up (for a sphere any frame will do).
#pragma once

#include <beespace/not_given.hpp>

#include <cstdint>

namespace beespace {

/// @brief The shape of what must stay free.
enum class SeparationShape : std::uint8_t {
  kSphere,     ///< Closer than the threshold, in any direction.
  kEllipsoid,  ///< As a sphere, stretched upwards and downwards: for rotor wash.
  kCylinder,   ///< Closer horizontally than the threshold and vertically than a height.
};

/// @brief What must stay free between two agents.
struct Separation {
  SeparationShape shape = SeparationShape::kSphere;  ///< The shape.
  /// @brief Of an ellipsoid: its vertical semi-axis as a multiple of the horizontal one; above
  /// zero. About 3 keeps small quadrotors out of each other's rotor wash.
  double vertical_factor = 1.0;
  /// @brief Of a cylinder: half of its height, in metres; above zero. Must be given for one.
  double vertical_m = kNotGiven;

  friend constexpr bool operator==(const Separation&, const Separation&) = default;
};

}  // namespace beespace
