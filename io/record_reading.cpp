#include "io/record_reading.hpp"

#include "io/excerpt.hpp"
#include "io/number.hpp"
#include "io/skipped_records.hpp"

#include <array>

namespace beespace::io {
namespace {

Error at_column(ErrorCode code, std::string message, std::size_t column) {
  Error error{code, std::move(message), {}};
  error.place.column = column + 1;
  return error;
}

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

Error number_error(NumberKind kind, std::string_view text, const TableLayout& layout,
                   std::size_t axis) {
  const std::size_t column = layout.choice.axes[axis];
  const std::string name(coordinate_name(layout, axis));
  if (kind == NumberKind::kNotFinite) {
    return at_column(
        ErrorCode::kNotFinite,
        excerpt(text) + " is no position (" + name + "); correct it" + std::string(kOrLeaveOut),
        column);
  }
  if (kind == NumberKind::kTooLarge) {
    return at_column(ErrorCode::kNotFinite,
                     excerpt(text) + " is too large for a number (" + name + "); correct it",
                     column);
  }
  if (kind == NumberKind::kTooSmall) {
    return at_column(ErrorCode::kOutsideDomain,
                     excerpt(text) + " is too small for a number (" + name +
                         "); use 0, or 3.9e-121 m to 2.6e+120 m",
                     column);
  }
  if (text.empty()) {
    return at_column(ErrorCode::kNotANumber,
                     "the field is empty where a number should be (" + name + "); fill it in" +
                         std::string(kOrLeaveOut),
                     column);
  }
  const bool comma = text.find(',') != std::string_view::npos;
  return at_column(ErrorCode::kNotANumber,
                   excerpt(text) + " is not a number (" + name + "); " +
                       (comma ? std::string("write decimals with a point, not with a comma")
                              : "correct it" + std::string(kOrLeaveOut)),
                   column);
}

Error count_error(std::size_t count, const TableLayout& layout, std::string_view line) {
  return {ErrorCode::kColumnCount,
          std::to_string(count) + (count == 1 ? " column" : " columns") + " where the " +
              (layout.header.empty() ? "table" : "header") + " has " +
              std::to_string(layout.columns) + ": " + excerpt(line) + "; correct it" +
              std::string(kOrLeaveOut),
          {}};
}

}  // namespace

std::optional<Error> read_record(std::string_view line, const TableLayout& layout, Point& point) {
  if (line.size() > kLongestLine) {
    return Error{ErrorCode::kMalformedRecord,
                 "a line of " + std::to_string(line.size()) + " bytes, beginning with " +
                     excerpt(line) + ", is too long for a record (the limit is 1 MiB)",
                 {}};
  }
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
  if (line.find('\0') != std::string_view::npos) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "a NUL byte stands in this line: " + excerpt(line) +
                     "; this is no text table, or it is damaged",
                 {}};
  }
  if (const auto text = without_padding(line); !text.empty() && text.front() == '#') {
    return Error{ErrorCode::kMalformedRecord,
                 "a comment line: " + excerpt(line) + "; comments are not read, remove it" +
                     std::string(kOrLeaveOut),
                 {}};
  }
  if (!cursor.problem().empty()) {
    return at_column(ErrorCode::kMalformedRecord,
                     std::string(cursor.problem()) + ": " + excerpt(line) +
                         "; correct the line, a record may not span several lines",
                     count);
  }
  if (count != layout.columns) return count_error(count, layout, line);

  std::array<double, 3> values = {};
  std::array<NumberKind, 3> kinds = {};
  std::optional<std::size_t> bad;
  for (std::size_t axis = 0; axis < choice.dimensions; ++axis) {
    texts[axis] = without_padding(texts[axis]);  // inside quotes
    kinds[axis] = parse_number(texts[axis], values[axis]);
    const bool first = !bad || choice.axes[axis] < choice.axes[*bad];
    if (kinds[axis] != NumberKind::kNumber && first) bad = axis;
  }
  if (bad) return number_error(kinds[*bad], texts[*bad], layout, *bad);
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
