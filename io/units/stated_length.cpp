#include "io/units/stated_length.hpp"

#include "io/bytes/number_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace beespace::io {

std::optional<StatedLength> parse_stated(std::string_view text, Quantity quantity) {
  const bool length = quantity == Quantity::kLength;
  const Unit ours = length ? Unit::kMetre : Unit::kMetrePerSecond;
  if (const auto bare = parse_number(text)) return StatedLength{*bare, *bare, ours, true};
  // The number ends where the last digit or point is; "m2" is no unit, so no digit belongs to one.
  const std::size_t last = text.find_last_of("0123456789.");
  if (last == std::string_view::npos) return std::nullopt;
  std::string_view word = text.substr(last + 1);
  if (word.starts_with(' ')) word.remove_prefix(1);
  const auto value = parse_number(text.substr(0, last + 1));
  const auto unit = unit_of_text(word, quantity);
  if (!value || !unit) return std::nullopt;
  return StatedLength{in_metric(*value, *unit), *value, *unit};
}

std::optional<double> parse_amount(std::string_view text, std::string_view words) {
  const bool length = words == "metres";
  if (!length && words != "metres per second") return parse_number(text);
  const auto stated = parse_stated(text, length ? Quantity::kLength : Quantity::kSpeed);
  return stated ? std::optional(stated->metric) : std::nullopt;
}

std::string text_of(const StatedLength& stated) {
  return exact(stated.value) + " " + std::string(symbol_of(stated.unit));
}

std::optional<double> exactly_in(const StatedLength& stated, Unit unit) {
  constexpr double kFeetPerLevel = 100.0;
  if (stated.unit == unit) return stated.value;
  if (stated.unit == Unit::kFoot && unit == Unit::kFlightLevel) {
    const double levels = stated.value / kFeetPerLevel;
    if (std::fma(levels, kFeetPerLevel, -stated.value) == 0.0) return levels;
  }
  if (stated.unit == Unit::kFlightLevel && unit == Unit::kFoot) {
    const double feet = stated.value * kFeetPerLevel;
    if (std::fma(stated.value, kFeetPerLevel, -feet) == 0.0) return feet;
  }
  if (unit == Unit::kCentimetre) {
    constexpr double kHundredthsPerFoot = 3048.0;
    constexpr double kHundredths = 100.0;
    const auto feet = exactly_in(stated, Unit::kFoot);
    if (!feet) return std::nullopt;
    const double hundredths = *feet * kHundredthsPerFoot;
    const double centimetres = hundredths / kHundredths;
    if (std::fma(*feet, kHundredthsPerFoot, -hundredths) == 0.0 &&
        std::fma(centimetres, kHundredths, -hundredths) == 0.0) {
      return centimetres;
    }
  }
  return std::nullopt;
}

Unit compared_in(const std::optional<StatedLength>& vertical, Unit height_unit) {
  if (!vertical) return Unit::kMetre;
  const Unit unit = height_unit == Unit::kMetre ? Unit::kCentimetre : height_unit;
  return exactly_in(*vertical, unit) ? unit : Unit::kMetre;
}

double as_compared(double height, Unit height_unit) {
  if (height_unit != Unit::kMetre) return height;
  constexpr double kCentimetres = 100.0;
  const double whole = std::round(height * kCentimetres);
  // The double that is nearest to so many hundredths is what was written so.
  return whole / kCentimetres == height ? whole : height * kCentimetres;
}

namespace {

// A suggestion to type: not every digit of what is rounded anyway.
std::string short_number(double value) {
  std::array<char, 32> text = {};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace

std::string vertical_note(const std::optional<StatedLength>& vertical, Unit height_unit) {
  if (!vertical) return {};
  const std::string heights(symbol_of(height_unit));
  const Unit compared = compared_in(vertical, height_unit);
  if (height_unit == Unit::kMetre && compared != Unit::kMetre) {
    return text_of(*vertical) + ", compared with heights in metres as " + exact(vertical->metric) +
           " m";
  }
  if (compared != Unit::kMetre) {
    return text_of(*vertical) + ", compared with heights in " + heights + " as they stand";
  }
  if (height_unit != Unit::kMetre) {
    return "compared in metres, to which heights in " + heights + " are rounded; a threshold in " +
           heights + " (--vertical " + short_number(from_metric(vertical->metric, height_unit)) +
           heights + ") is compared with them as they stand";
  }
  if (vertical->unit == Unit::kMetre) return {};
  return text_of(*vertical) + ", compared in metres, as heights are";
}

}  // namespace beespace::io
