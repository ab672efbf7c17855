#include "io/tracks/motive_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/fields.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/body_records.hpp"
#include "io/tracks/long_records.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

struct MotiveLayout {
  BodyTable table = {};
  std::string length_unit;  // as the file calls it: "Meters"
  std::size_t data_offset = 0;
  std::size_t others = 0;  // columns of markers and bones
};

std::string_view cell(const std::vector<std::string>& cells, std::size_t at) {
  return at < cells.size() ? std::string_view(cells[at]) : std::string_view();
}

// Of "Length Units,Meters" in the first line.
std::string value_behind(const std::vector<std::string>& cells, std::string_view name) {
  const auto found = std::find(cells.begin(), cells.end(), name);
  return found != cells.end() && std::next(found) != cells.end() ? *std::next(found)
                                                                 : std::string();
}

// The axis that a column of the last line of the header is of; 3 of others.
std::size_t axis_named(std::string_view name) {
  return name == "X" ? 0 : name == "Y" ? 1 : name == "Z" ? 2 : 3;
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

std::optional<MotiveLayout> motive_layout(std::string_view text) {
  constexpr std::size_t kMostLines = 12;
  if (!text.starts_with("Format Version,")) return std::nullopt;
  MotiveLayout layout;
  std::vector<std::vector<std::string>> above;
  std::vector<std::string> names;
  std::size_t at = 0;
  for (std::size_t line = 0; line < kMostLines && at < text.size(); ++line) {
    const Line read = line_at(text, at, '\n');
    at = read.next;
    std::vector<std::string> cells = cells_of_line(read.text, ',');
    if (line == 0) layout.length_unit = value_behind(cells, "Length Units");
    if (cell(cells, 0) == "Frame") {
      names = std::move(cells);
      layout.table.lines_before = line + 1;
      break;
    }
    if (line > 0 && cells.size() > 2) above.push_back(std::move(cells));
  }
  if (names.empty() || above.size() < 3 || !names[1].starts_with("Time")) return std::nullopt;
  layout.table.program = "Motive (OptiTrack)";
  layout.table.y_is_up = true;
  layout.table.time = 1;
  layout.table.columns = names.size();
  layout.data_offset = at;
  const std::vector<std::string>& types = above[0];
  const std::vector<std::string>& called = above[1];
  const std::vector<std::string>& kinds = above.back();
  for (std::size_t column = 2; column < names.size(); ++column) {
    const bool is_body = cell(types, column) == "Rigid Body";
    if (!is_body && !cell(types, column).empty()) ++layout.others;
    const std::size_t axis = axis_named(names[column]);
    if (!is_body || cell(kinds, column) != "Position" || axis > 2) continue;
    const std::string_view name = cell(called, column);
    std::vector<BodyColumns>& bodies = layout.table.bodies;
    if (axis == 0) bodies.push_back({std::string(name)});
    if (bodies.empty() || bodies.back().name != name) return std::nullopt;
    bodies.back().axes[axis] = column;
  }
  const std::vector<BodyColumns>& bodies = layout.table.bodies;
  const bool whole = std::all_of(bodies.begin(), bodies.end(), [](const BodyColumns& body) {
    return std::find(body.axes.begin(), body.axes.end(), 0U) == body.axes.end();
  });
  if (bodies.empty() || !whole) return std::nullopt;
  layout.table.unit = symbol_of_length(layout.length_unit);
  return layout;
}

std::optional<Error> problem_of(const MotiveLayout& layout, const RecordingAssembly& assembly) {
  const auto invalid = [](std::string message) {
    return Error{ErrorCode::kInvalidArgument, std::move(message), {}};
  };
  if (has_unclear_names(layout.table.bodies)) {
    return invalid(
        "two rigid bodies of this take of Motive have one name, or none: give each a name of its "
        "own in Motive, and export it again");
  }
  if (layout.table.unit.empty()) {
    return invalid("this take of Motive has its lengths in " +
                   (layout.length_unit.empty() ? "a unit that it does not name"
                                               : excerpt(layout.length_unit)) +
                   "; export it with Length Units: Meters");
  }
  // Its start is a time of a clock on the wall, by the computer that recorded it.
  return own_beginning(layout.table, assembly);
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
  LongRecords records = body_records(text.substr(motive->data_offset), motive->table);
  const std::size_t bodies = motive->table.bodies.size();
  records.note = "positions of " + std::to_string(bodies) +
                 (bodies == 1 ? " rigid body" : " rigid bodies") +
                 " as Motive exports them: y, which is upwards there, is z here, and -z is y";
  records.description = "take of Motive (OptiTrack)";
  if (motive->others > 0) assembly.note("markers and bones of the take are left out");
  return read_long_records(records, {}, assembly);
}

}  // namespace beespace::io
