// Lengths and speeds as typed, with or without a unit: "100", "5NM", "0.3km", "1000ft", "10kt".
#pragma once

#include "io/units/units.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// What was typed: so that it can be compared in its own unit. Without a unit it is in ours.
struct StatedLength {
  double metric = 0.0;  // metres, or metres per second, rounded once
  double value = 0.0;
  Unit unit = Unit::kMetre;
};

// Nothing where it is none. "inf" and "nan" are read, too.
std::optional<StatedLength> parse_stated(std::string_view text, Quantity quantity);

// A number of what `words` say: of "metres" and "metres per second" also one with another unit
// behind it, in ours.
std::optional<double> parse_amount(std::string_view text, std::string_view words);

// "1000 ft".
std::string text_of(const StatedLength& stated);

// In that unit, where nothing is rounded: in its own one, and a hundred feet are a flight level.
std::optional<double> exactly_in(const StatedLength& stated, Unit unit);

// A vertical threshold and the heights of an input in a unit other than the metre: whether the
// threshold is exactly_in() that, so that they can be compared as they stand. What is converted
// otherwise is rounded.
bool compares_as_stated(const std::optional<StatedLength>& vertical, Unit height_unit);

// To be said of that; empty where all is in metres.
std::string vertical_note(const std::optional<StatedLength>& vertical, Unit height_unit);

}  // namespace beespace::io
