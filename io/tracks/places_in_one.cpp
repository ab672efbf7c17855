#include "io/tracks/places_in_one.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/column_names.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/first_fields.hpp"
#include "io/tracks/track_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::io {
namespace {

// A name that jq takes behind a point.
bool is_plain_key(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  });
}

bool begins_with(const TableLayout& table, std::string_view text, std::size_t column,
                 std::string_view first) {
  const FirstFields fields = first_fields(text, table, column);
  return !fields.empty() && fields.front() == first;
}

// The line to type that makes other JSON of it by that program of jq.
std::string jq_line(std::string_view program, std::string_view file, JsonFrom from) {
  std::string line = "jq -c ";
  if (from == JsonFrom::kLines) line += "--unbuffered ";
  line.append("'").append(program).append("'");
  if (from == JsonFrom::kLines) return line + " before '| beespace watch'";
  return line.append(" FILE > ").append(file);
}

Error place_in_array(const TableLayout& table, std::size_t column, JsonFrom from) {
  const std::string at = "." + table.names[column];
  std::string program = ". + {x: ";
  program.append(at).append("[0], y: ").append(at).append("[1], z: ").append(at);
  program.append("[2]} | del(").append(at).append(")");
  return missing_column(column_text(table, column) +
                        " is an array; of three numbers x, y, z make values of their own: " +
                        jq_line(program, "xyz.ndjson", from) +
                        " (or lon, lat, height, where these are degrees)");
}

Error place_in_object(const TableLayout& table, std::size_t column, JsonFrom from) {
  std::string program = ". + .";
  program.append(table.names[column]).append(" | del(.").append(table.names[column]).append(")");
  return missing_column(column_text(table, column) +
                        " is an object; put what it holds beside the others: " +
                        jq_line(program, "flat.ndjson", from));
}

}  // namespace

bool keys_name_position(const std::vector<std::string_view>& keys) {
  unsigned found = 0;
  for (const std::string_view name : keys) {
    const Role role = read_column_name(track_columns(), name).role;
    if (const auto axis = part_within(Role::kLongitude, role)) found |= 1U << *axis;
    if (const auto axis = part_within(Role::kX, role)) found |= 8U << *axis;
  }
  constexpr unsigned kDegrees = 3;
  return (found & kDegrees) == kDegrees || (found & (kDegrees << 3U)) == kDegrees << 3U;
}

std::optional<Error> place_in_one_value(std::string_view text, const TableLayout& table,
                                        JsonFrom from) {
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const std::string& name = table.names[i];
    if (!is_one_of("position pos xyz location coordinates translation", plain_name(name)) ||
        !is_plain_key(name)) {
      continue;
    }
    if (begins_with(table, text, i, "an array")) return place_in_array(table, i, from);
    if (begins_with(table, text, i, "an object")) return place_in_object(table, i, from);
  }
  return std::nullopt;
}

bool holds_objects(std::string_view text, const TableLayout& table, std::string_view name) {
  const auto at = std::find(table.names.begin(), table.names.end(), name);
  return at != table.names.end() &&
         begins_with(table, text, static_cast<std::size_t>(at - table.names.begin()), "an object");
}

Error places_within_objects(JsonFrom from) {
  constexpr std::string_view kUnnest =
      "[paths(scalars) as $p | {key: ($p | map(tostring) | join(\".\")), value: getpath($p)}] | "
      "from_entries";
  return missing_column(
      "no key names a position, but there are objects within these objects; bring what is in them "
      "up, with names as pose.x, and read that: " +
      jq_line(kUnnest, "flat.ndjson", from));
}

Error places_in_list(const ListedPlaces& listed, JsonFrom from) {
  return missing_column(listed.what + "; make an object of each: " +
                        jq_line(listed.program, "flat.ndjson", from) + listed.more);
}

std::optional<Error> columns_of_pandas(std::string_view text, const TableLayout& table) {
  if (table.names.size() < 3 || table.names[1].empty() || table.names[1] != table.names[2]) {
    return std::nullopt;
  }
  const bool axes = (begins_with(table, text, 1, "x") && begins_with(table, text, 2, "y")) ||
                    (begins_with(table, text, 1, "lon") && begins_with(table, text, 2, "lat")) ||
                    (begins_with(table, text, 1, "lat") && begins_with(table, text, 2, "lon"));
  if (!axes) return std::nullopt;
  return Error{ErrorCode::kMissingColumn,
               "the columns have two lines of names, as pandas writes those of a MultiIndex; make "
               "a record of each bee and time: python3 -c \"import pandas; "
               "pandas.read_csv('FILE', header=[0, 1], index_col=0).stack(0)"
               ".rename_axis(['time', 'id']).to_csv('bees.csv')\" (call it time_s instead of time "
               "where it is in seconds)",
               {}};
}

}  // namespace beespace::io
