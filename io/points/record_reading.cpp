#include "io/points/record_reading.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/table/record_problems.hpp"

#include <array>

namespace beespace::io {
namespace {

std::string_view coordinate_name(const TableLayout& layout, std::size_t axis) {
  constexpr std::array<std::string_view, 3> kGeographic = {"longitude", "latitude", "height"};
  constexpr std::array<std::string_view, 3> kMetres = {"x", "y", "z"};
  constexpr std::array<std::string_view, 3> kUnknown = {"first coordinate", "second coordinate",
                                                        "third coordinate"};
  switch (layout.choice.evidence) {
    case Frame::kWgs84:
      return kGeographic[axis];
    case Frame::kMetres:
      return kMetres[axis];
    case Frame::kAuto:
      break;
  }
  return kUnknown[axis];
}

}  // namespace

std::optional<Error> read_record(std::string_view line, const TableLayout& layout, Point& point) {
  if (line.size() > kLongestLine) return long_line(line);
  std::array<std::string_view, 3> texts = {};
  Field field;
  std::size_t count = 0;
  FieldCursor cursor(line, layout.delimiter);
  const auto& choice = layout.choice;
  for (; cursor.next(field); ++count) {
    for (std::size_t axis = 0; axis < choice.dimensions; ++axis) {
      if (choice.axes[axis] == count) texts[axis] = field.text;
    }
  }
  if (auto problem = record_problem(line, layout, count, cursor.problem())) return problem;

  std::array<double, 3> values = {};
  std::array<NumberKind, 3> kinds = {};
  std::optional<std::size_t> bad;
  for (std::size_t axis = 0; axis < choice.dimensions; ++axis) {
    texts[axis] = without_padding(texts[axis]);  // inside quotes
    kinds[axis] = parse_number(texts[axis], values[axis]);
    const bool first = !bad || choice.axes[axis] < choice.axes[*bad];
    if (kinds[axis] != NumberKind::kNumber && first) bad = axis;
  }
  if (bad) {
    return number_problem(kinds[*bad], texts[*bad], coordinate_name(layout, *bad),
                          "3.9e-121 m to 2.6e+120 m", choice.axes[*bad]);
  }
  point = {values[0], values[1], values[2]};
  return std::nullopt;
}

Field field_at(std::string_view line, char delimiter, std::size_t column) {
  Field field;
  FieldCursor cursor(line, delimiter);
  for (std::size_t i = 0; cursor.next(field); ++i) {
    if (i == column) return field;
  }
  return {};
}

}  // namespace beespace::io
