#include "io/encounters/daidalus_encounter.hpp"

#include "io/aircraft/aircraft_report.hpp"
#include "io/bytes/characters.hpp"
#include "io/encounters/encounter_lines.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_table.hpp"
#include "io/units/units.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::string_view kEncounter = "a DAIDALUS encounter";

// The words between commas and blanks.
std::vector<std::string_view> values_in(std::string_view line) {
  constexpr std::string_view kBetween = ", \t\r";
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(kBetween);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(kBetween), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

// Where the two lines of names and units are.
struct Front {
  std::vector<std::string_view> names;
  std::vector<std::string_view> units;
  std::size_t names_line = 0;  // 0-based
  std::size_t units_line = 0;
  std::size_t rows = 0;  // where the line behind them begins
};

std::optional<Front> front_of(std::string_view text) {
  constexpr std::size_t kMostLines = 64;
  Front front;
  std::size_t offset = 0;
  for (std::size_t line = 0; line < kMostLines && offset < text.size(); ++line) {
    const Line here = line_at(text, offset, '\n');
    offset = here.next;
    if (says_nothing(here.text)) continue;
    if (front.names.empty()) {
      front.names = values_in(here.text);
      front.names_line = line;
      continue;
    }
    front.units = values_in(here.text);
    front.units_line = line;
    front.rows = offset;
    return front;
  }
  return std::nullopt;
}

enum class Holds : std::uint8_t {
  kNothing,
  kId,
  kLatitude,
  kLongitude,
  kAltitude,
  kEast,
  kNorth,
  kUp,
  kTrack,
  kGroundSpeed,
  kClimb,
  kVelocityEast,
  kVelocityNorth,
  kVelocityUp,
  kTime,
};

// How the readers of tables call it, and what its unit measures; of angles and names nothing.
struct Column {
  Holds holds;
  std::string_view words;  // of DAIDALUS, in lower case
  std::string_view name;   // ours
  std::optional<Quantity> quantity;
};

constexpr std::array<Column, 14> kColumns = {{
    {Holds::kId, "name id aircraft vehicle", "id", std::nullopt},
    {Holds::kLatitude, "lat latitude", "lat", std::nullopt},
    {Holds::kLongitude, "lon long longitude", "lon", std::nullopt},
    {Holds::kAltitude, "alt altitude", "alt", Quantity::kLength},
    {Holds::kEast, "sx", "east", Quantity::kLength},
    {Holds::kNorth, "sy", "north", Quantity::kLength},
    {Holds::kUp, "sz", "up", Quantity::kLength},
    {Holds::kTrack, "trk track", "track", std::nullopt},
    {Holds::kGroundSpeed, "gs groundspeed groundspd", "gs", Quantity::kSpeed},
    {Holds::kClimb, "vs verticalspeed hdot", "vertical_rate", Quantity::kSpeed},
    {Holds::kVelocityEast, "vx", "ve", Quantity::kSpeed},
    {Holds::kVelocityNorth, "vy", "vn", Quantity::kSpeed},
    {Holds::kVelocityUp, "vz", "vu", Quantity::kSpeed},
    {Holds::kTime, "time clock tm st", "time", Quantity::kTime},
}};

const Column* column_of(std::string_view name) {
  const std::string lower = lower_case(name);
  for (const Column& column : kColumns) {
    if (is_one_of(column.words, lower)) return &column;
  }
  return nullptr;
}

bool has(const std::vector<std::string_view>& names, Holds what) {
  return std::any_of(names.begin(), names.end(), [what](std::string_view name) {
    const Column* const column = column_of(name);
    return column != nullptr && column->holds == what;
  });
}

bool is_unit(std::string_view word) {
  return (word.size() > 2 && word.front() == '[' && word.back() == ']') ||
         is_one_of("unitless none", lower_case(word));
}

// "ft" of "[ft]".
std::string_view bare(std::string_view unit) {
  return unit.front() == '[' ? unit.substr(1, unit.size() - 2) : unit;
}

// As DAIDALUS writes it.
std::string_view usual_unit(const Column* column) {
  if (column == nullptr || column->holds == Holds::kId) return "[none]";
  if (column->holds == Holds::kEast || column->holds == Holds::kNorth) return "[nmi]";
  if (column->holds == Holds::kClimb || column->holds == Holds::kVelocityUp) return "[fpm]";
  if (!column->quantity) return "[deg]";
  switch (*column->quantity) {
    case Quantity::kLength:
      return "[ft]";
    case Quantity::kSpeed:
      return "[knot]";
    default:
      return "[s]";
  }
}

// The name of a column as the readers of tables know it, with its unit.
Result<std::string> renamed(std::string_view name, std::string_view unit, std::size_t place) {
  const Column* column = column_of(name);
  if (column == nullptr) return "unread_" + std::to_string(place + 1);
  const auto wrong = [&](std::string_view wanted) {
    return at_column(ErrorCode::kUnsupportedFormat,
                     "column " + excerpt(name) + " is in " + excerpt(unit) + ", where " +
                         std::string(wanted) + " should be; convert it first",
                     place);
  };
  std::string text(column->name);
  if (column->quantity) {
    const auto known = unit_of_text(bare(unit), *column->quantity);
    if (!known) return wrong("one of " + list_units(*column->quantity));
    return text.append("_").append(symbol_of(*known));
  }
  const bool angle = column->holds != Holds::kId;
  if (angle && !is_one_of("deg degree degrees", lower_case(bare(unit)))) return wrong("[deg]");
  return text;
}

// The text as a table: our names in the line of names, nothing in that of units and in comments, so
// that all lines keep their numbers.
Result<std::string> as_table(std::string_view text, const Front& front) {
  std::size_t first = front.rows;
  while (first < text.size() && says_nothing(line_at(text, first, '\n').text)) {
    first = line_at(text, first, '\n').next;
  }
  const std::string_view row = line_at(text, std::min(first, text.size()), '\n').text;
  const char between = row.find(',') != std::string_view::npos ? ',' : ' ';
  std::string table(front.names_line, '\n');
  for (std::size_t i = 0; i < front.names.size(); ++i) {
    const auto name = renamed(front.names[i], front.units[i], i);
    if (!name) {
      Error error = name.error();
      error.location.line = front.units_line + 1;
      return error;
    }
    if (i > 0) table += between;
    table += *name;
  }
  table.append(front.units_line - front.names_line + 1, '\n');
  for (std::size_t offset = front.rows; offset < text.size();) {
    const Line line = line_at(text, offset, '\n');
    if (!says_nothing(line.text)) table.append(line.text);
    table += '\n';
    offset = line.next;
  }
  return table;
}

}  // namespace

bool is_daidalus_encounter(std::string_view text) {
  const auto front = front_of(text);
  if (!front || front->names.size() < 4 || front->units.size() != front->names.size()) return false;
  const auto& names = front->names;
  const bool position = (has(names, Holds::kLatitude) && has(names, Holds::kLongitude)) ||
                        (has(names, Holds::kEast) && has(names, Holds::kNorth));
  return position && has(names, Holds::kTime) &&
         std::all_of(front->units.begin(), front->units.end(), is_unit);
}

std::optional<Error> missing_units_of_encounter(std::string_view text) {
  const auto front = front_of(text);
  if (!front || front->names.size() < 4 || front->units.size() != front->names.size()) {
    return std::nullopt;
  }
  const auto& names = front->names;
  const bool position = (has(names, Holds::kLatitude) && has(names, Holds::kLongitude)) ||
                        (has(names, Holds::kEast) && has(names, Holds::kNorth));
  // Other tables have commas between their names, where they have them between values.
  const std::string_view line = line_at(text, text.find(names.front()), '\n').text;
  const std::string_view row =
      line_at(text, text.find(front->units.front(), line.size()), '\n').text;
  const bool so_written =
      line.find(',') == std::string_view::npos && row.find(',') != std::string_view::npos;
  if (!position || !so_written || !has(names, Holds::kId) || !has(names, Holds::kTime) ||
      std::any_of(front->units.begin(), front->units.end(), is_unit)) {
    return std::nullopt;
  }
  std::string units;
  for (const std::string_view name : names) {
    const Column* const column = column_of(name);
    units.append(units.empty() ? "" : " ").append(usual_unit(column));
  }
  return Error{
      ErrorCode::kMissingColumn,
      "this is a DAIDALUS encounter without its line of units, which says what its numbers "
      "are in; add it below the names, if it is so, as by sed '1a " +
          units + "' FILE > with-units.daa",
      {}};
}

std::optional<Error> read_daidalus_encounter(std::string_view text, RecordingAssembly& assembly) {
  if (auto problem = text_problem(text)) return problem;
  if (auto problem = fixed_layout_problem(assembly.options(), kEncounter)) return problem;
  const auto front = front_of(text);
  if (!front || !has(front->names, Holds::kId)) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no column NAME in this encounter, which tells aircraft apart; add it",
                 {}};
  }
  const auto table = as_table(text, *front);
  if (!table) return table.error();
  auto layout = find_track_layout(*table, assembly.options(), false);
  if (!layout) return layout.error();
  SourceFacts facts = facts_of(*layout, "DAIDALUS encounter");
  facts.of_aircraft = true;
  for (UnitTaken& taken : facts.units) taken.reason = "the line of units says so";
  if (auto error = assembly.agree(facts)) return error;
  assembly.note("the first aircraft of each time is the ownship");
  const bool geographic = layout->frame == Frame::kWgs84;
  if (!geographic) assembly.note("sx counts to the east, sy to the north, sz upwards");
  RecordsBefore none;
  return read_track_records(std::string_view(*table).substr(layout->table.data_offset), *layout, {},
                            RecordPlace::kLineAndColumn, none, assembly);
}

}  // namespace beespace::io
