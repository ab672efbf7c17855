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
  bool bare = false;  // nothing was typed behind the number
};

// Nothing where it is none. "inf" and "nan" are read, too.
std::optional<StatedLength> parse_stated(std::string_view text, Quantity quantity);

// A number of what `words` say: of "metres" and "metres per second" also one with another unit
// behind it, in ours.
std::optional<double> parse_amount(std::string_view text, std::string_view words);

// "1000 ft".
std::string text_of(const StatedLength& stated);

// In that unit, where nothing is rounded: in its own one; a hundred feet are a flight level, and a
// foot is 30.48 cm.
std::optional<double> exactly_in(const StatedLength& stated, Unit unit);

// In which unit a vertical threshold and heights are compared: that of the heights, where the
// threshold is exactly_in() it, so that they are compared as they stand. A threshold in feet and
// heights in metres are compared in centimetres: 10668.0 m and 10363.2 m are 1000 ft apart, which
// no fraction of two shows. What is converted otherwise is rounded to metres.
Unit compared_in(const std::optional<StatedLength>& vertical, Unit height_unit);
inline bool compares_as_stated(const std::optional<StatedLength>& vertical, Unit height_unit) {
  return compared_in(vertical, height_unit) != Unit::kMetre;
}
// A height of that input as it is compared. Of metres with two decimals that is a whole number.
double as_compared(double height, Unit height_unit);

// To be said of that; empty where all is in metres.
std::string vertical_note(const std::optional<StatedLength>& vertical, Unit height_unit);

}  // namespace beespace::io
