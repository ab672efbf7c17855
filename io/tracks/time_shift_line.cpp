#include "io/tracks/time_shift_line.hpp"

#include "io/units/units.hpp"

#include <algorithm>
#include <string_view>

namespace beespace::io {
namespace {

// "SECONDS" of "s", "MILLISECONDS".
std::string upper_case(std::string_view unit) {
  std::string text(unit == "s" ? "seconds" : unit);
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

}  // namespace

std::string time_shift_line(const TrackLayout& layout) {
  const char delimiter = layout.table.delimiter;
  if (delimiter != ',' && delimiter != ';' && delimiter != '\t') return {};
  const std::string between = delimiter == '\t' ? "\\t" : std::string(1, delimiter);
  const std::string time = std::to_string(layout.time->column + 1);
  const Unit unit = layout.time->unit;
  // All digits stay: without a format awk writes six.
  return "awk -F'" + between + "' -v OFS='" + between +
         "' -v behind=" + upper_case(symbol_of(unit)) + " 'NR>" +
         std::to_string(layout.table.lines_before) + "{$" + time + "=sprintf(\"%.6f\",$" + time +
         "+behind)}1' FILE > set.csv";
}

}  // namespace beespace::io
