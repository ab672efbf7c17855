// What the caller says of units: "height=ft,speed=kt,climb=ft/min", by role; or "metric",
// "aviation".
#pragma once

#include "io/units/units.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <string>
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

// What holds where neither the header, nor a known source, nor a unit by role says anything, and in
// which units people are told.
enum class UnitConvention : std::uint8_t {
  kNone,
  kMetric,    // metres, metres a second
  kAviation,  // feet, knots, feet a minute; told in nautical miles and feet, too
};

// kUnstated where nothing is said.
struct UnitOverrides {
  Unit position = Unit::kUnstated;
  Unit height = Unit::kUnstated;
  Unit speed = Unit::kUnstated;
  Unit climb = Unit::kUnstated;
  UnitConvention convention = UnitConvention::kNone;
  // What else of the question speaks of aviation, as "--separation enroute": then a unit that is
  // not said is asked for.
  std::string spoken_of = {};

  // Whether a unit is said by role.
  [[nodiscard]] bool any() const;
  [[nodiscard]] Unit of(UnitRole role) const;
};

// An empty text says nothing. Errors: kInvalidArgument.
Result<UnitOverrides> read_unit_overrides(std::string_view text);

}  // namespace beespace::io
