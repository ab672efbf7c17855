#include "io/tracks/sides.hpp"

#include "io/bytes/characters.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/first_fields.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::array<std::string_view, 2> kPositiveSides = {"e east", "n north"};
constexpr std::array<std::string_view, 2> kNegativeSides = {"w west", "s south"};
constexpr std::array<std::string_view, 2> kSideNames = {"E and W", "N and S"};

bool is_negative(std::size_t axis, std::string_view side) {
  return is_one_of(kNegativeSides[axis], lower_case(without_padding(side)));
}

bool is_side(std::size_t axis, std::string_view side) {
  return is_negative(axis, side) ||
         is_one_of(kPositiveSides[axis], lower_case(without_padding(side)));
}

// "N/S", "lat_dir", "hemisphere"; not "direction", which is that of a flight.
bool names_side(const std::string& name) {
  const std::vector<std::string> words = split_words(name);
  const auto is_all = [&words](std::string_view these) {
    return std::all_of(words.begin(), words.end(),
                       [these](const std::string& word) { return is_one_of(these, word); });
  };
  constexpr std::string_view kBeside = "dir direction side ref indicator";
  return !words.empty() && !is_all(kBeside) &&
         is_all(
             "n s e w ns ew nsindicator ewindicator north south east west hemisphere hemi dir "
             "direction side ref latref lonref latdir londir lat latitude lon long lng "
             "longitude indicator");
}

}  // namespace

Sides find_sides(std::string_view text, const TableLayout& table) {
  Sides sides;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (!names_side(table.names[i])) continue;
    const FirstFields first = first_fields(text, table, i);
    for (std::size_t axis = 0; axis < sides.size(); ++axis) {
      if (!first.empty() && !sides[axis] && is_side(axis, first.front())) sides[axis] = i;
    }
  }
  return sides;
}

std::string take_side(std::size_t axis, std::string_view side, double& degrees) {
  if (!is_side(axis, side)) {
    return excerpt(side) + " is none of " + std::string(kSideNames[axis]) + "; fill it in";
  }
  if (is_negative(axis, side)) {
    degrees = -std::abs(degrees);
  } else if (degrees < 0.0) {
    return excerpt(side) + " contradicts the sign of the degrees; correct one of them";
  }
  return {};
}

std::optional<Error> southern_or_western(std::string_view text, const TableLayout& table,
                                         const Sides& sides) {
  if (!sides[0] && !sides[1]) return std::nullopt;
  RecordWalk walk(text, 0, table);
  while (walk.next()) {
    for (std::size_t axis = 0; axis < sides.size(); ++axis) {
      if (!sides[axis]) continue;
      const Field field = field_at(walk.record(), table.delimiter, *sides[axis]);
      if (!is_negative(axis, field.text)) continue;
      Error error = at_column(ErrorCode::kMalformedRecord,
                              "this place is " + excerpt(field.text) + " by " +
                                  column_text(table, *sides[axis]) +
                                  ", which is not read here; write degrees to the south and west "
                                  "with a minus, or ask 'beespace replay' or 'predict'",
                              *sides[axis]);
      error.location.line = walk.line() + 1;
      error.location.record = walk.row();
      return error;
    }
  }
  return std::nullopt;
}

}  // namespace beespace::io
