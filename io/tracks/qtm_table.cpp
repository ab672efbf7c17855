#include "io/tracks/qtm_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/fields.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/body_records.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

struct QtmLayout {
  BodyTable table = {};
  bool markers = false;
  std::size_t offset = 0;
};

// "NO_OF_FRAMES", not "Frame", nor a number, nor an empty cell.
bool is_key(std::string_view cell) {
  return !cell.empty() && std::all_of(cell.begin(), cell.end(),
                                      [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; });
}

// "robot1 X", then "Y" and "Z", or "robot1 Y" and "robot1 Z"; and "Residual" before the next one.
void find_bodies(const std::vector<std::string>& names, BodyTable& table) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == "Residual" && !table.bodies.empty()) table.bodies.back().residual = i;
    if (i + 2 >= names.size() || names[i].size() <= 2 || !names[i].ends_with(" X")) continue;
    const std::string name = names[i].substr(0, names[i].size() - 2);
    const auto is_axis = [&name](std::string_view cell, char axis) {
      if (cell.empty() || cell.back() != axis) return false;
      cell.remove_suffix(1);
      return cell.empty() || (cell.ends_with(' ') && cell.substr(0, cell.size() - 1) == name);
    };
    if (is_axis(names[i + 1], 'Y') && is_axis(names[i + 2], 'Z')) {
      table.bodies.push_back({name, {i, i + 1, i + 2}});
    }
  }
}

// Without a line that names the columns: three for each of the markers, in their order.
bool take_unnamed_columns(const std::vector<std::string>& cells,
                          const std::vector<std::string>& markers, BodyTable& table) {
  // A line may end with a tab.
  const bool ends_empty = cells.size() == 3 * markers.size() + 1 && cells.back().empty();
  if (cells.size() != 3 * markers.size() && !ends_empty) return false;
  for (std::size_t i = 0; i < markers.size(); ++i) {
    table.bodies.push_back({markers[i], {3 * i, 3 * i + 1, 3 * i + 2}});
  }
  return true;
}

// The lines that begin with words in capitals, and the one that names columns, if there is one.
std::optional<QtmLayout> qtm_layout(std::string_view text) {
  constexpr std::size_t kMostQtmLines = 1'000;  // an EVENT is a line
  if (!text.starts_with("NO_OF_FRAMES\t")) return std::nullopt;
  QtmLayout layout;
  BodyTable& table = layout.table;
  table.program = "QTM (Qualisys)";
  table.delimiter = '\t';
  table.unit = "mm";
  std::string included;
  double rate = 0.0;
  std::vector<std::string> markers;
  while (table.lines_before < kMostQtmLines && layout.offset < text.size()) {
    const Line line = line_at(text, layout.offset, '\n');
    const std::vector<std::string> cells = cells_of_line(line.text, '\t');
    if (cells.empty()) {
      layout.offset = line.next;
      ++table.lines_before;
      continue;
    }
    if (is_key(cells.front()) && cells.size() > 1) {
      layout.offset = line.next;
      ++table.lines_before;
      if (cells[0] == "DATA_INCLUDED") included = cells[1];
      if (cells[0] == "FREQUENCY" && parse_number(cells[1], rate) != NumberKind::kNumber) rate = 0;
      if (cells[0] != "MARKER_NAMES") continue;
      markers.assign(cells.begin() + 1, cells.end());
      while (!markers.empty() && markers.back().empty()) markers.pop_back();
      continue;
    }
    layout.markers = included == "3D";
    if (!layout.markers && included != "6D") return std::nullopt;
    table.columns = cells.size();
    find_bodies(cells, table);
    table.by_line = cells.size() < 2 || cells[0] != "Frame" || cells[1] != "Time";
    table.time = 1;
    if (table.by_line) table.pictures_per_second = rate;
    if (table.by_line && !(rate > 0.0)) return std::nullopt;
    if (table.bodies.empty()) {
      const bool taken = layout.markers && take_unnamed_columns(cells, markers, table);
      return taken && !table.bodies.empty() ? std::optional(layout) : std::nullopt;
    }
    layout.offset = line.next;
    ++table.lines_before;
    return layout;
  }
  return std::nullopt;
}

// "robot1" of "robot1 - 2", as QTM calls the markers of a rigid body; else nothing.
std::string body_of(const std::string& marker) {
  const std::size_t at = marker.rfind(" - ");
  return at == std::string::npos ? std::string() : marker.substr(0, at);
}

// Two markers of one body would each be a bee near the other.
std::optional<Error> markers_of_one_body(const std::vector<BodyColumns>& markers) {
  std::set<std::string> bodies;
  for (const BodyColumns& marker : markers) {
    const std::string body = body_of(marker.name);
    if (body.empty() || bodies.insert(body).second) continue;
    return Error{ErrorCode::kInvalidArgument,
                 "several markers are of " + excerpt(body) + ", one of them " +
                     excerpt(marker.name) +
                     ", so that each would be a bee near the others; export rigid bodies (6D) from "
                     "QTM instead of markers, or leave the columns of the others out of the table",
                 {}};
  }
  return std::nullopt;
}

}  // namespace

bool is_qtm_table(std::string_view text) {
  return qtm_layout(text).has_value();
}

std::optional<Error> read_qtm_table(std::string_view text, RecordingAssembly& assembly) {
  if (auto problem = text_problem(text)) return problem;
  const auto layout = qtm_layout(text);
  if (!layout) return Error{ErrorCode::kUnsupportedFormat, "this is no export of QTM", {}};
  if (has_unclear_names(layout->table.bodies)) {
    return Error{
        ErrorCode::kInvalidArgument,
        "two of the bodies of this export of QTM have one name, or none: give each a name of its "
        "own, and export it again",
        {}};
  }
  if (layout->markers) {
    if (auto problem = markers_of_one_body(layout->table.bodies)) return problem;
  }
  if (auto problem = own_beginning(layout->table, assembly)) return problem;
  LongRecords records = body_records(text.substr(layout->offset), layout->table);
  const std::size_t bodies = layout->table.bodies.size();
  const std::string_view what = layout->markers ? (bodies == 1 ? " marker" : " markers")
                                                : (bodies == 1 ? " rigid body" : " rigid bodies");
  records.note =
      "positions of " + std::to_string(bodies) + std::string(what) + " as QTM exports them, in mm";
  if (layout->table.by_line) {
    records.note += ", " + exact(*layout->table.pictures_per_second) + " pictures a second";
  }
  records.description = "export of QTM (Qualisys)";
  return read_long_records(records, {}, assembly);
}

}  // namespace beespace::io
