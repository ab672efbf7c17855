#include "io/tracks/json_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/json_cells.hpp"
#include "io/tracks/known_tables.hpp"
#include "io/tracks/local_positions.hpp"
#include "io/tracks/places_in_one.hpp"
#include "io/tracks/ros_table.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_columns.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_table.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

enum class Form : std::uint8_t { kNone, kRecords, kColumns, kIndex, kSplit, kOneRecord };

std::vector<std::string_view> keys_of(JsonMap object) {
  std::vector<std::string_view> keys;
  for (const auto [key, value] : object) {
    if (keys.size() == JsonCells::kMostNames) break;
    keys.push_back(key);
  }
  return keys;
}

bool has_position(JsonElement record) {
  JsonMap object;
  return record.get(object) && keys_name_position(keys_of(object));
}

std::optional<JsonArray> list_in(JsonMap object, std::string_view key) {
  JsonElement member;
  JsonArray list;
  if (!object.get(key, member) || !member.get(list)) return std::nullopt;
  return list;
}

// The first of a list that is an object.
bool has_records(JsonArray list) {
  constexpr int kLookedAt = 16;
  int looked_at = 0;
  for (const JsonElement element : list) {
    if (has_position(element)) return true;
    if (++looked_at == kLookedAt) break;
  }
  return false;
}

Form form_of_object(JsonMap object) {
  const auto data = list_in(object, "data");
  if (data && list_in(object, "columns")) return Form::kSplit;
  if (data && has_records(*data)) return Form::kRecords;
  if (keys_name_position(keys_of(object))) {
    const JsonElement first = (*object.begin()).value;
    const bool nested = first.is_object() || first.kind() == JsonKind::kArray;
    return nested ? Form::kColumns : Form::kOneRecord;
  }
  const bool index = object.size() > 0 && has_position((*object.begin()).value);
  return index ? Form::kIndex : Form::kNone;
}

Form form_of(JsonElement root) {
  JsonArray list;
  if (root.get(list)) return has_records(list) ? Form::kRecords : Form::kNone;
  JsonMap object;
  return root.get(object) ? form_of_object(object) : Form::kNone;
}

// ---- The keys of rows ------------------------------------------------------------------------

// A key that numbers a row, as pandas writes the index of a frame: "0", "17". Not "004123".
bool numbers_row(std::string_view key) {
  if (key.starts_with('-')) key.remove_prefix(1);
  if (key.empty() || key.find_first_not_of("0123456789") != std::string_view::npos) return false;
  return key.size() == 1 || key.front() != '0';
}

// A flight is no id here: many have none, or that of another day.
bool has_id_column(const JsonCells& cells) {
  return std::any_of(cells.names().begin(), cells.names().end(), [](const std::string& name) {
    return read_column_name(track_columns(), name).role == Role::kId && !names_flight(name);
  });
}

// Where no column says who a row is of, keys that number no rows do.
std::optional<Error> learn_keys(const std::vector<std::string_view>& keys, JsonCells& cells) {
  if (has_id_column(cells) || std::all_of(keys.begin(), keys.end(), numbers_row)) {
    return std::nullopt;
  }
  for (const std::string_view key : keys) {
    // Several at once are an id for each row.
    if (!key.starts_with('(') || !key.ends_with(')') || key.find(',') == key.npos) continue;
    return Error{ErrorCode::kMalformedRecord,
                 "rows are named by several values at once, as " + excerpt(key) +
                     "; write them as columns (with pandas, after reset_index())",
                 {}};
  }
  return cells.learn_id();
}

// ---- Records -------------------------------------------------------------------------------

template <class Elements>
std::optional<Error> take_records(const Elements& elements, JsonCells& cells) {
  for (const JsonElement element : elements) {
    JsonMap record;
    if (!element.get(record)) continue;
    if (auto error = cells.learn(record)) return error;
  }
  for (const JsonElement element : elements) cells.add(element);
  return std::nullopt;
}

// Records that are members of an object.
std::optional<Error> take_index(JsonMap object, JsonCells& cells) {
  std::vector<std::string_view> keys;
  keys.reserve(object.size());
  for (const auto [key, value] : object) {
    keys.push_back(key);
    JsonMap record;
    if (!value.get(record)) continue;
    if (auto error = cells.learn(record)) return error;
  }
  if (auto error = learn_keys(keys, cells)) return error;
  for (const auto [key, value] : object) cells.add(value, key);
  return std::nullopt;
}

// ---- Columns -------------------------------------------------------------------------------

Error bad_column(std::string_view name, const std::string& what) {
  return {
      ErrorCode::kMalformedRecord, "the column " + excerpt(name) + " " + what + "; correct it", {}};
}

// A column as a list of values, and in `keys` of which rows, where it says so.
std::optional<Error> take_column(std::string_view name, JsonElement column,
                                 std::vector<JsonElement>& values,
                                 std::vector<std::string_view>& keys) {
  JsonArray list;
  JsonMap by_row;
  if (column.get(list)) {
    for (const JsonElement value : list) values.push_back(value);
    return std::nullopt;
  }
  if (!column.get(by_row)) {
    return bad_column(name, "is " + std::string(json_kind(column)) +
                                " where its values should be, a list or an object");
  }
  for (const auto [key, value] : by_row) {
    values.push_back(value);
    keys.push_back(key);
  }
  return std::nullopt;
}

std::optional<Error> take_columns(JsonMap object, JsonCells& cells) {
  std::vector<std::vector<JsonElement>> columns;
  std::vector<std::string_view> rows;
  std::string first;
  for (const auto [name, column] : object) {
    const std::size_t before = cells.names().size();
    if (auto error = cells.learn(name)) return error;
    if (cells.names().size() == before) return bad_column(name, "is there twice");
    std::vector<std::string_view> keys;
    if (auto error = take_column(name, column, columns.emplace_back(), keys)) return error;
    if (columns.size() == 1) {
      rows = keys;
      first = name;
    }
    if (columns.back().size() != columns.front().size()) {
      return bad_column(name, "has " + std::to_string(columns.back().size()) + " values, but " +
                                  excerpt(first) + " has " +
                                  std::to_string(columns.front().size()));
    }
    if (keys != rows) return bad_column(name, "has other rows than " + excerpt(first));
  }
  if (auto error = learn_keys(rows, cells)) return error;
  for (std::size_t row = 0; !columns.empty() && row < columns.front().size(); ++row) {
    cells.begin_row();
    for (std::size_t i = 0; i < columns.size(); ++i) cells.set(i, columns[i][row]);
    if (cells.id_place()) cells.set(*cells.id_place(), rows[row]);
    cells.end_row();
  }
  return std::nullopt;
}

// Of any length; that of size() has 24 bits.
std::size_t length_of(JsonArray list) {
  std::size_t length = 0;
  for (auto at = list.begin(); at != list.end(); ++at) ++length;
  return length;
}

// 'index' names the rows, by numbers or by who they are of; nothing where it does not say that.
std::vector<JsonElement> ids_beside(JsonMap object, const JsonCells& cells) {
  std::vector<JsonElement> ids;
  const auto index = list_in(object, "index");
  if (!index || has_id_column(cells)) return ids;
  bool numbers = true;
  for (const JsonElement of : *index) {
    ids.push_back(of);
    numbers = numbers && of.is_number();
  }
  if (numbers) ids.clear();
  return ids;
}

std::optional<Error> take_split(JsonMap object, JsonCells& cells) {
  const JsonArray names = list_in(object, "columns").value_or(JsonArray());
  for (const JsonElement name : names) {
    std::string_view text;
    if (!name.get(text)) {
      return Error{ErrorCode::kMalformedRecord,
                   "'columns' names a column by " + std::string(json_kind(name)) +
                       "; give it a text as its name",
                   {}};
    }
    const std::size_t before = cells.names().size();
    if (auto error = cells.learn(text)) return error;
    if (cells.names().size() == before) return bad_column(text, "is there twice");
  }
  const std::size_t columns = cells.names().size();
  std::uint64_t index = 0;
  const JsonArray rows = list_in(object, "data").value_or(JsonArray());
  const std::vector<JsonElement> ids = ids_beside(object, cells);
  if (!ids.empty()) {
    if (ids.size() != length_of(rows)) {
      return Error{ErrorCode::kMalformedRecord,
                   "'index' names " + std::to_string(ids.size()) + " rows, but 'data' has " +
                       std::to_string(length_of(rows)) + "; correct it",
                   {}};
    }
    if (auto error = cells.learn_id()) return error;
  }
  for (const JsonElement element : rows) {
    JsonArray values;
    if (!element.get(values) || values.size() != columns) {
      Error error{ErrorCode::kColumnCount,
                  "it does not have the " + std::to_string(columns) + " values of 'columns'",
                  {}};
      error.location.record = index;
      return error;
    }
    cells.begin_row();
    std::size_t place = 0;
    for (const JsonElement value : values) cells.set(place++, value);
    if (cells.id_place()) cells.set(place, ids[index]);
    cells.end_row();
    ++index;
  }
  return std::nullopt;
}

// ---- All together --------------------------------------------------------------------------

TableLayout layout_of(const JsonCells& cells) {
  TableLayout table;
  table.delimiter = kUnitSeparator;
  table.names = cells.names();
  table.contents = cells.contents();
  table.columns = table.names.size();
  return table;
}

// {"robot": "a", "pose": {"x": 1, "y": 2}}: whose places are in objects within each.
std::optional<Error> nested_places(const JsonCells& cells, const RecordingOptions& options) {
  const auto has = [&cells](std::string_view name) {
    return std::find(cells.names().begin(), cells.names().end(), name) != cells.names().end();
  };
  const bool of_messages = has("msg") || has("meta");  // of rosbridge, of mavlogdump
  const std::vector<std::string_view> keys(cells.names().begin(), cells.names().end());
  const bool named = keys_name_position(keys) || !options.columns.empty();
  if (named) return std::nullopt;
  if (cells.listed()) return places_in_list(*cells.listed(), JsonFrom::kFile);
  if (of_messages || !cells.has_objects()) return std::nullopt;
  return places_within_objects(JsonFrom::kFile);
}

std::optional<Error> read_cells(JsonCells& cells, std::string description, const std::string& stem,
                                RecordPlace place, RecordingAssembly& assembly) {
  const RecordingOptions& options = assembly.options();
  if (auto problem = nested_places(cells, options)) return problem;
  if (options.progress != nullptr) options.progress->total += cells.text().size();
  TableLayout table = layout_of(cells);
  auto ros = names_columns_of_ros(options)
                 ? find_ros_table(cells.text(), table, !names_position(options))
                 : std::nullopt;
  prefer_own_id(table, ros);
  auto layout =
      ros ? ros_layout(*ros, std::move(table), cells.text(), options, SeenRecords::kWhole)
          : choose_track_layout(std::move(table), cells.text(), options, SeenRecords::kWhole);
  if (!layout) {
    Error error = std::move(layout).error();
    error.location.column.reset();
    error.location.line.reset();
    return error;
  }
  settle_local_origin(options, *layout);
  if (layout->time && layout->time->clock) {
    layout->time->clock = assembly.common_clock(*layout->time->clock);
  }
  if (auto error = assembly.agree(facts_of(*layout, std::move(description)))) return error;
  for (std::string& note : layout->notes) assembly.note(std::move(note));
  const std::optional<std::size_t> id = layout->table.choice.id;
  if (id && id == cells.id_place()) {
    assembly.note("no column is an id: the keys of the rows are taken for the ids");
  }
  if (id) {
    cells.require_ids(*id);
  } else {
    assembly.note(layout->time ? "there is no id: each file is taken for one bee, named after it"
                               : "there is no id: bees are numbered in their order, from 0");
  }
  if (place == RecordPlace::kRecordAndName) assembly.count_records();
  RecordsBefore none;
  const std::string bee = is_named_after_file(*layout) ? assembly.name_of_source(stem) : stem;
  return read_track_records(cells.text(), *layout, bee, place, none, assembly);
}

std::string_view description_of(Form form) {
  switch (form) {
    case Form::kColumns:
      return "JSON, a table by columns";
    case Form::kSplit:
      return "JSON, a table with its names apart";
    default:
      return "JSON, a table of records";
  }
}

}  // namespace

bool is_json_table(JsonElement root) {
  return form_of(root) != Form::kNone;
}

bool is_json_lines(std::string_view text) {
  std::size_t objects = 0;
  while (!text.empty() && objects < 2) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = without_padding(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) continue;
    if (line.front() != '{') return false;
    if (objects == 0 && line.back() != '}') return false;
    ++objects;
  }
  return objects == 2;
}

std::optional<Error> read_json_table(JsonElement root, const std::string& stem,
                                     RecordingAssembly& assembly) {
  const Form form = form_of(root);
  JsonCells cells;
  JsonArray list;
  JsonMap object;
  std::optional<Error> error;
  if (root.get(list)) {
    error = take_records(list, cells);
  } else if (root.get(object)) {
    switch (form) {
      case Form::kRecords:
        error = take_records(*list_in(object, "data"), cells);
        break;
      case Form::kColumns:
        error = take_columns(object, cells);
        break;
      case Form::kSplit:
        error = take_split(object, cells);
        break;
      case Form::kIndex:
        error = take_index(object, cells);
        break;
      case Form::kOneRecord:
      case Form::kNone:
        error = take_records(std::vector<JsonElement>{root}, cells);
        break;
    }
  }
  if (error) return error;
  return read_cells(cells, std::string(description_of(form)), stem, RecordPlace::kRecordAndName,
                    assembly);
}

std::optional<Error> read_json_lines(std::string_view text, const std::string& stem,
                                     RecordingAssembly& assembly) {
  // Twice over the lines: what names there are must be known before the first row.
  JsonCells cells;
  for (const bool learning : {true, false}) {
    std::uint64_t number = 0;
    std::string_view rest = text;
    JsonParser parser;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      const std::string_view line = without_padding(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      ++number;
      JsonElement root;
      const std::string_view problem = line.empty() ? std::string_view() : parser.parse(line, root);
      if (learning) {
        JsonMap record;
        if (line.empty() || !problem.empty() || !root.get(record)) continue;
        if (auto error = cells.learn(record)) return error;
        continue;
      }
      if (line.empty()) {
        cells.skip_line();
        continue;
      }
      if (problem.empty()) {
        cells.add(root);
        continue;
      }
      Error error = json_syntax_error(line, problem, "each object must be whole in one line");
      error.location.line = number;
      if (auto fatal = assembly.bad(std::move(error))) return fatal;
      cells.skip_line();
    }
  }
  return read_cells(cells, "JSON, an object a line", stem, RecordPlace::kLineAndName, assembly);
}

}  // namespace beespace::io
