#include "cli/console/summary_line.hpp"

#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace beespace::cli {

void append_summary_line(std::string& out, std::string_view label, std::string_view text) {
  constexpr std::size_t kLabelWidth = 11;
  out += "  ";
  out += label;
  out.append(kLabelWidth - std::min(kLabelWidth, label.size()), ' ');
  out += text;
  out += '\n';
}

std::string text_of(const io::UnitTaken& taken) {
  return taken.of + " in " + std::string(io::symbol_of(taken.unit)) + ": " + taken.reason;
}

std::string text_of(const io::RepeatedIds& repeated) {
  return io::grouped(repeated.count) + (repeated.count == 1 ? " record has" : " records have") +
         " the id of another one before: the first is " + io::excerpt(repeated.id) +
         ", of data rows " + std::to_string(repeated.first_row) + " and " +
         std::to_string(repeated.second_row);
}

void append_units(std::string& out, const std::vector<io::UnitTaken>& units) {
  for (const io::UnitTaken& taken : units) {
    append_summary_line(out, "units", printable(text_of(taken)));
  }
}

std::string_view datum_text(io::HeightDatum datum) {
  switch (datum) {
    case io::HeightDatum::kUnstated:
      return "";
    case io::HeightDatum::kEllipsoid:
      return "above the WGS84 ellipsoid";
    case io::HeightDatum::kMeanSeaLevel:
      return "above mean sea level";
    case io::HeightDatum::kPressure:
      return "pressure altitude";
    case io::HeightDatum::kHome:
      return "above the place of take-off";
  }
  return "";
}

void append_vertical(std::string& out, const std::optional<io::StatedLength>& vertical,
                     io::Unit height_unit) {
  const std::string note = vertical_note(vertical, height_unit);
  if (!note.empty()) append_summary_line(out, "vertical", note);
}

void note_units(const std::vector<io::UnitTaken>& units,
                const std::optional<io::StatedLength>& vertical, io::Unit height_unit,
                std::vector<std::string>& notes) {
  for (const io::UnitTaken& taken : units) notes.push_back(text_of(taken));
  std::string note = vertical_note(vertical, height_unit);
  if (!note.empty()) notes.push_back("--vertical " + std::move(note));
}

std::string separation_text(double threshold_m, const std::optional<double>& vertical_m,
                            bool inclusive) {
  const char* const how = inclusive ? " m or closer" : " m (closer than)";
  std::string text = io::exact(threshold_m) + how;
  if (!vertical_m) return text;
  return "horizontally " + text + ", and in height " + io::exact(*vertical_m) + how;
}

}  // namespace beespace::cli
