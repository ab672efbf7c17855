// Which unit the numbers of an input were taken for, and why.
#pragma once

#include "io/units/units.hpp"

#include <cstdint>
#include <string>

namespace beespace::io {

// What tells a unit.
enum class UnitEvidence : std::uint8_t {
  kNamed,   // the header, or the format
  kAsked,   // the caller
  kSource,  // that the whole header is the documented one of a known source
  kUsual,   // nothing: ours, where nothing speaks of another one
};

// The unit that some numbers of the input were taken for, and why: to be told.
struct UnitTaken {
  std::string of;  // "heights", "speeds", "climb rates", "x and y"
  Unit unit = Unit::kMetre;
  UnitEvidence evidence = UnitEvidence::kUsual;
  std::string reason;  // as a phrase

  friend bool operator==(const UnitTaken&, const UnitTaken&) = default;
};

}  // namespace beespace::io
