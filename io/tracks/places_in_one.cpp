#include "io/tracks/places_in_one.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/column_names.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/first_fields.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
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

}  // namespace

std::optional<Error> place_in_one_value(std::string_view text, const TableLayout& table) {
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const std::string& name = table.names[i];
    if (!is_one_of("position pos xyz location coordinates translation", plain_name(name)) ||
        !is_plain_key(name)) {
      continue;
    }
    if (begins_with(table, text, i, "an array")) {
      std::string message = column_text(table, i);
      message.append(" is an array; of three numbers x, y, z make values of their own: ")
          .append("jq -c '. + {x: .")
          .append(name)
          .append("[0], y: .")
          .append(name)
          .append("[1], z: .")
          .append(name)
          .append("[2]} | del(.")
          .append(name)
          .append(")' FILE > xyz.ndjson (or lon, lat, height, where these are degrees)");
      return missing_column(std::move(message));
    }
    if (begins_with(table, text, i, "an object")) {
      std::string message = column_text(table, i);
      message.append(" is an object; put what it holds beside the others: jq -c '. + .")
          .append(name)
          .append(" | del(.")
          .append(name)
          .append(")' FILE > flat.ndjson");
      return missing_column(std::move(message));
    }
  }
  return std::nullopt;
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
