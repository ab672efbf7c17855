#include "cli/analysis/stated_length.hpp"

#include "cli/analysis/number_text.hpp"

#include <array>
#include <cstdio>

namespace beespace::cli {

std::optional<StatedLength> parse_stated(std::string_view text, io::Quantity quantity) {
  const bool length = quantity == io::Quantity::kLength;
  const io::Unit ours = length ? io::Unit::kMetre : io::Unit::kMetrePerSecond;
  if (const auto bare = parse_number(text)) return StatedLength{*bare, *bare, ours};
  // The number ends where the last digit or point is; "m2" is no unit, so no digit belongs to one.
  const std::size_t last = text.find_last_of("0123456789.");
  if (last == std::string_view::npos) return std::nullopt;
  std::string_view word = text.substr(last + 1);
  if (word.starts_with(' ')) word.remove_prefix(1);
  const auto value = parse_number(text.substr(0, last + 1));
  const auto unit = io::unit_of_text(word, quantity);
  if (!value || !unit) return std::nullopt;
  return StatedLength{io::in_metric(*value, *unit), *value, *unit};
}

std::optional<double> parse_amount(std::string_view text, std::string_view words) {
  const bool length = words == "metres";
  if (!length && words != "metres per second") return parse_number(text);
  const auto stated = parse_stated(text, length ? io::Quantity::kLength : io::Quantity::kSpeed);
  return stated ? std::optional(stated->metric) : std::nullopt;
}

std::string text_of(const StatedLength& stated) {
  return exact(stated.value) + " " + std::string(io::symbol_of(stated.unit));
}

bool compares_as_stated(const std::optional<StatedLength>& vertical, io::Unit height_unit) {
  return vertical && vertical->unit == height_unit && height_unit != io::Unit::kMetre;
}

namespace {

// A suggestion to type: not every digit of what is rounded anyway.
std::string short_number(double value) {
  std::array<char, 32> text = {};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace

std::string vertical_note(const std::optional<StatedLength>& vertical, io::Unit height_unit) {
  if (!vertical) return {};
  const std::string heights(io::symbol_of(height_unit));
  if (compares_as_stated(vertical, height_unit)) {
    return text_of(*vertical) + ", compared with heights in " + heights + " as they stand";
  }
  if (height_unit != io::Unit::kMetre) {
    return "compared in metres, to which heights in " + heights + " are rounded; a threshold in " +
           heights + " (--vertical " +
           short_number(io::from_metric(vertical->metric, height_unit)) + heights +
           ") is compared with them as they stand";
  }
  if (vertical->unit == io::Unit::kMetre) return {};
  return text_of(*vertical) + ", compared in metres, as heights are";
}

}  // namespace beespace::cli
