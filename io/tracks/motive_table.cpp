#include "io/tracks/motive_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

using Cells = std::vector<std::string>;

// Where a body's coordinates are, in the order of x, y, z of the file.
struct BodyColumns {
  std::string name;
  std::array<std::size_t, 3> axes = {0, 0, 0};
};

struct MotiveLayout {
  std::string length_unit;  // as the file calls it: "Meters"
  std::vector<BodyColumns> bodies;
  std::size_t columns = 0;
  std::size_t time = 0;
  std::size_t data_offset = 0;
  std::uint64_t lines_before = 0;
  bool named_twice = false;
  std::size_t others = 0;  // columns of markers and bones
};

Cells cells_of(std::string_view line) {
  Cells cells;
  FieldCursor cursor(line, ',');
  for (Field field; cursor.next(field);) cells.emplace_back(without_padding(field.text));
  return cells;
}

std::string_view cell(const Cells& cells, std::size_t at) {
  return at < cells.size() ? std::string_view(cells[at]) : std::string_view();
}

// Of "Length Units,Meters" in the first line.
std::string value_behind(const Cells& cells, std::string_view name) {
  const auto found = std::find(cells.begin(), cells.end(), name);
  return found != cells.end() && std::next(found) != cells.end() ? *std::next(found)
                                                                 : std::string();
}

// The axis that a column of the last line of the header is of; 3 of others.
std::size_t axis_named(std::string_view name) {
  return name == "X" ? 0 : name == "Y" ? 1 : name == "Z" ? 2 : 3;
}

std::optional<MotiveLayout> motive_layout(std::string_view text) {
  constexpr std::size_t kMostLines = 12;
  if (!text.starts_with("Format Version,")) return std::nullopt;
  MotiveLayout layout;
  std::vector<Cells> above;
  Cells names;
  std::size_t at = 0;
  for (std::size_t line = 0; line < kMostLines && at < text.size(); ++line) {
    const Line read = line_at(text, at, '\n');
    at = read.next;
    Cells cells = cells_of(read.text);
    if (line == 0) layout.length_unit = value_behind(cells, "Length Units");
    if (cell(cells, 0) == "Frame") {
      names = std::move(cells);
      layout.lines_before = line + 1;
      break;
    }
    if (line > 0 && cells.size() > 2) above.push_back(std::move(cells));
  }
  if (names.empty() || above.size() < 3 || !names[1].starts_with("Time")) return std::nullopt;
  layout.time = 1;
  layout.columns = names.size();
  layout.data_offset = at;
  const Cells& types = above[0];
  const Cells& called = above[1];
  const Cells& kinds = above.back();
  for (std::size_t column = 2; column < names.size(); ++column) {
    const bool is_body = cell(types, column) == "Rigid Body";
    if (!is_body && !cell(types, column).empty()) ++layout.others;
    const std::size_t axis = axis_named(names[column]);
    if (!is_body || cell(kinds, column) != "Position" || axis > 2) continue;
    const std::string_view name = cell(called, column);
    if (axis == 0) {
      layout.named_twice = layout.named_twice || name.empty() ||
                           std::any_of(layout.bodies.begin(), layout.bodies.end(),
                                       [&](const BodyColumns& body) { return body.name == name; });
      layout.bodies.push_back({std::string(name)});
    }
    if (layout.bodies.empty() || layout.bodies.back().name != name) return std::nullopt;
    layout.bodies.back().axes[axis] = column;
  }
  const bool whole =
      std::all_of(layout.bodies.begin(), layout.bodies.end(), [](const BodyColumns& body) {
        return std::find(body.axes.begin(), body.axes.end(), 0U) == body.axes.end();
      });
  if (layout.bodies.empty() || !whole) return std::nullopt;
  return layout;
}

// "m" of "Meters"; empty of what is not known.
std::string symbol_of_length(std::string_view unit) {
  const std::string lower = lower_case(unit);
  if (lower == "meters" || lower == "m") return "m";
  if (lower == "centimeters" || lower == "cm") return "cm";
  if (lower == "millimeters" || lower == "mm") return "mm";
  if (lower == "feet" || lower == "ft") return "ft";
  return {};
}

// As it is written, with the other sign.
std::string negated(std::string_view number) {
  if (number.empty() || number.find_first_of("123456789") == std::string_view::npos) {
    return std::string(number);
  }
  if (number.front() == '-') return std::string(number.substr(1));
  return "-" + std::string(number.substr(number.front() == '+' ? 1 : 0));
}

// The same as a table with a record for each body in each line, z upwards.
std::string body_records(std::string_view text, const MotiveLayout& layout) {
  std::string out;
  std::vector<std::string_view> fields;
  std::uint64_t lines = 0;
  RecordWalk walk(text, layout.data_offset, '\n');
  while (walk.next()) {
    out.append((walk.line() - lines) * layout.bodies.size(), '\n');
    lines = walk.line() + 1;
    fields.clear();
    FieldCursor cursor(walk.record(), ',');
    for (Field field; cursor.next(field);) fields.push_back(without_padding(field.text));
    const bool whole = fields.size() == layout.columns && cursor.problem().empty();
    for (const BodyColumns& body : layout.bodies) {
      if (!whole) {
        out.append("a row of ").append(std::to_string(fields.size())).append(" values\n");
        continue;
      }
      out.append(fields[layout.time]) += kUnitSeparator;
      out.append(body.name) += kUnitSeparator;
      out.append(fields[body.axes[0]]) += kUnitSeparator;
      out.append(negated(fields[body.axes[2]])) += kUnitSeparator;
      out.append(fields[body.axes[1]]) += '\n';
    }
  }
  return out;
}

std::optional<Error> problem_of(const MotiveLayout& layout, const RecordingAssembly& assembly) {
  const auto invalid = [](std::string message) {
    return Error{ErrorCode::kInvalidArgument, std::move(message), {}};
  };
  if (layout.named_twice) {
    return invalid(
        "two rigid bodies of this take of Motive have one name, or none: give each a name of its "
        "own in Motive, and export it again");
  }
  if (symbol_of_length(layout.length_unit).empty()) {
    return invalid("this take of Motive has its lengths in " +
                   (layout.length_unit.empty() ? "a unit that it does not name"
                                               : excerpt(layout.length_unit)) +
                   "; export it with Length Units: Meters");
  }
  // Its start is a time of a clock on the wall, by the computer that recorded it.
  if (assembly.has_several() && assembly.options().time_unit == Unit::kUnstated) {
    return invalid(
        "times of a take of Motive count from its own beginning, so that it shares no clock with "
        "other inputs; read it alone, or say --time-unit s if all begin at one moment");
  }
  return std::nullopt;
}

}  // namespace

bool is_motive_table(std::string_view text) {
  return motive_layout(text).has_value();
}

std::optional<Error> read_motive_table(std::string_view text, RecordingAssembly& assembly) {
  if (auto problem = text_problem(text)) return problem;
  const auto motive = motive_layout(text);
  if (!motive) return Error{ErrorCode::kUnsupportedFormat, "this is no take of Motive", {}};
  if (auto error = problem_of(*motive, assembly)) return error;
  const RecordingOptions& options = assembly.options();
  const std::string records = body_records(text, *motive);
  if (options.progress != nullptr) options.progress->total += records.size();
  const std::string unit = symbol_of_length(motive->length_unit);
  TableLayout table;
  table.delimiter = kUnitSeparator;
  table.names = {"time_s", "id", "x_" + unit, "y_" + unit, "z_" + unit};
  table.columns = table.names.size();
  table.contents = {ColumnContent::kNumber, ColumnContent::kText, ColumnContent::kNumber,
                    ColumnContent::kNumber, ColumnContent::kNumber};
  table.lines_before = motive->lines_before;
  table.records_per_line = motive->bodies.size();
  auto layout = choose_track_layout(std::move(table), records, options, SeenRecords::kWhole);
  if (!layout) {
    Error error = std::move(layout).error();
    error.location.column.reset();
    return error;
  }
  const std::size_t bodies = motive->bodies.size();
  assembly.note("positions of " + std::to_string(bodies) +
                (bodies == 1 ? " rigid body" : " rigid bodies") +
                " as Motive exports them: y, which is upwards there, is z here, and -z is y");
  if (motive->others > 0) assembly.note("markers and bones of the take are left out");
  if (auto error = assembly.agree(facts_of(*layout, "take of Motive (OptiTrack)"))) return error;
  for (std::string& note : layout->notes) assembly.note(std::move(note));
  RecordsBefore none;
  return read_track_records(records, *layout, {}, RecordPlace::kLineAndName, none, assembly);
}

}  // namespace beespace::io
