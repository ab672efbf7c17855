#include "io/tracks/qtm_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/fields.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/body_records.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

struct QtmLayout {
  BodyTable table = {};
  std::size_t offset = 0;
};

std::vector<std::string> tab_cells(std::string_view line) {
  std::vector<std::string> cells;
  FieldCursor cursor(line, '\t');
  for (Field field; cursor.next(field);) cells.emplace_back(without_padding(unquoted(field)));
  return cells;
}

// "robot1 X", "Y", "Z", and "Residual" before the next body.
void find_bodies(const std::vector<std::string>& names, BodyTable& table) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool three = i + 2 < names.size() && names[i].size() > 2 && names[i].ends_with(" X") &&
                       names[i + 1] == "Y" && names[i + 2] == "Z";
    if (three) {
      table.bodies.push_back({names[i].substr(0, names[i].size() - 2), {i, i + 1, i + 2}});
    } else if (names[i] == "Residual" && !table.bodies.empty()) {
      table.bodies.back().residual = i;
    }
  }
}

std::optional<QtmLayout> qtm_layout(std::string_view text) {
  constexpr std::size_t kMostQtmLines = 30;
  if (!text.starts_with("NO_OF_FRAMES\t")) return std::nullopt;
  QtmLayout layout;
  BodyTable& table = layout.table;
  table.program = "QTM (Qualisys)";
  table.delimiter = '\t';
  table.unit = "mm";
  bool bodies = false;
  while (table.lines_before < kMostQtmLines && layout.offset < text.size()) {
    const Line line = line_at(text, layout.offset, '\n');
    const std::vector<std::string> cells = tab_cells(line.text);
    layout.offset = line.next;
    ++table.lines_before;
    if (cells.size() > 1 && cells[0] == "DATA_INCLUDED") bodies = cells[1] == "6D";
    if (cells.size() < 2 || cells[0] != "Frame" || cells[1] != "Time") continue;
    table.time = 1;
    table.columns = cells.size();
    find_bodies(cells, table);
    if (!bodies || table.bodies.empty()) return std::nullopt;
    return layout;
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
    return Error{ErrorCode::kInvalidArgument,
                 "two of the bodies of this export of QTM have one name: give each a name of its "
                 "own, and export it again",
                 {}};
  }
  if (auto problem = own_beginning(layout->table, assembly)) return problem;
  LongRecords records = body_records(text.substr(layout->offset), layout->table);
  const std::size_t bodies = layout->table.bodies.size();
  records.note = "positions of " + std::to_string(bodies) +
                 (bodies == 1 ? " rigid body" : " rigid bodies") + " as QTM exports them, in mm";
  records.description = "export of QTM (Qualisys)";
  return read_long_records(records, {}, assembly);
}

}  // namespace beespace::io
