#include "analysis/text/unit_notes.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"

#include <utility>

namespace beespace::analysis {

std::string text_of(const io::UnitTaken& taken) {
  return taken.of + " in " + std::string(io::symbol_of(taken.unit)) + ": " + taken.reason;
}

std::string text_of(const io::RepeatedIds& repeated) {
  return io::grouped(repeated.count) + (repeated.count == 1 ? " record has" : " records have") +
         " the id of another one before: the first is " + io::excerpt(repeated.id) +
         ", of data rows " + std::to_string(repeated.first_row) + " and " +
         std::to_string(repeated.second_row);
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

void note_units(const std::vector<io::UnitTaken>& units,
                const std::optional<io::StatedLength>& vertical, io::Unit height_unit,
                std::vector<std::string>& notes) {
  for (const io::UnitTaken& taken : units) notes.push_back(text_of(taken));
  std::string note = vertical_note(vertical, height_unit);
  if (!note.empty()) notes.push_back("--vertical " + std::move(note));
}

}  // namespace beespace::analysis
