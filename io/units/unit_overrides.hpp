// What the caller says of units: "height=ft,speed=kt,climb=ft/min", by role.
#pragma once

#include "io/units/units.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <string_view>

namespace beespace::io {

// What a number of a table measures.
enum class UnitRole : std::uint8_t {
  kPosition,  // x and y; and z, where nothing is said of heights
  kHeight,    // a height, or z
  kSpeed,     // over ground, or along an axis
  kClimb,     // up or down
};

// "position", "height", "speed" or "climb".
std::string_view role_name(UnitRole role);
Quantity quantity_of(UnitRole role);

// kUnstated where nothing is said.
struct UnitOverrides {
  Unit position = Unit::kUnstated;
  Unit height = Unit::kUnstated;
  Unit speed = Unit::kUnstated;
  Unit climb = Unit::kUnstated;

  [[nodiscard]] bool any() const;
  [[nodiscard]] Unit of(UnitRole role) const;
};

// An empty text says nothing. Errors: kInvalidArgument.
Result<UnitOverrides> read_unit_overrides(std::string_view text);

}  // namespace beespace::io
