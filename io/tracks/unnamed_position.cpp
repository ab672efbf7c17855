#include "io/tracks/unnamed_position.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/column_names.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/echoed_messages.hpp"
#include "io/tracks/joined_place.hpp"
#include "io/tracks/mavlogdump.hpp"
#include "io/tracks/offered_columns.hpp"
#include "io/tracks/places_in_one.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace beespace::io {
namespace {

// Messages in objects within objects, which no column names.
std::optional<Error> nested_problem(std::string_view text, const TableLayout& table) {
  const auto has = [&table](std::string_view name) {
    return std::find(table.names.begin(), table.names.end(), name) != table.names.end();
  };
  if (has("meta") && has("data")) return dumped_json_problem();
  if (!has("topic") || !has("msg") || (!has("op") && !holds_objects(text, table, "msg"))) {
    return std::nullopt;
  }
  return Error{ErrorCode::kUnsupportedFormat,
               "these are messages of rosbridge, whose positions are nested; make an object a line "
               "of them, and read that: jq -c 'select((.op // \"publish\") == \"publish\" and "
               ".msg.pose) | "
               "(.msg.pose.pose // .msg.pose).position as $p | .msg.header as $h | {id: .topic, "
               "time_s: (($h.stamp.sec // $h.stamp.secs) + ($h.stamp.nanosec // $h.stamp.nsecs) * "
               "1e-9), \"header.frame_id\": $h.frame_id, x: $p.x, y: $p.y, z: $p.z}' FILE "
               "> poses.ndjson",
               {}};
}

// Lights of a drone, as programs for shows write them beside its path: a time, and its colours.
std::optional<Error> lights_problem(const TableLayout& table) {
  constexpr std::size_t kTimeAndColours = 4;
  if (table.names.size() > kTimeAndColours || !names_colours(table)) return std::nullopt;
  return missing_column(
      "these are the colours of lights only, and no position; leave this file out, as by moving it "
      "to another folder (" +
      list_columns(table) + ")");
}

}  // namespace

bool names_colours(const TableLayout& table) {
  const auto has = [&table](std::string_view word) {
    return std::any_of(table.names.begin(), table.names.end(), [word](const std::string& name) {
      const std::string lower = lower_case(name);
      return lower == word || lower == word.substr(0, 1) ||
             (lower.starts_with(word) && lower.find_first_of(" _[(") == word.size());
    });
  };
  return has("red") && has("green") && has("blue");
}

std::optional<Error> nameless_position(std::string_view text, const Header& header) {
  const bool overridden = header.override_of(Role::kX) || header.override_of(Role::kLongitude);
  const bool named = (header.has(Role::kX) && header.has(Role::kY)) ||
                     (header.has(Role::kLongitude) && header.has(Role::kLatitude));
  if (overridden || named) return std::nullopt;
  const TableLayout& table = header.table();
  if (auto problem = place_in_one_value(text, table, JsonFrom::kFile)) return problem;
  if (auto problem = columns_of_pandas(text, table)) return problem;
  if (const auto joined = column_of_joined_place(table)) {
    return missing_column(
        column_text(table, *joined) +
        " seems to hold latitude and longitude in one; make two columns of it, as by "
        "sed 's/\"//g; 1s/" +
        table.names[*joined] + "/latitude,longitude/' FILE > split.csv, and read that");
  }
  if (auto problem = nested_problem(text, table)) return problem;
  if (auto problem = lights_problem(table)) return problem;
  if (auto problem = echoed_messages(table)) return problem;
  if (table.names.size() == 1 && table.columns == 1) {
    return missing_column(
        "the first line has one cell, '" + table.names.front() +
        "', and no header that tells the columns: if it is the name of the drone, leave "
        "it out, as by sed 1d FILE > plain/FILE in a new folder 'plain', and say which "
        "columns are which, as in beespace replay plain --columns "
        "frame=1,x=2,y=3,z=4 --fps N, or time=1,x=2,y=3,z=4");
  }
  if (!table.names.empty()) {
    const std::string metric = offered_columns(header, false);
    return missing_column("the header names no position (x and y, or longitude and latitude)" +
                          (metric.empty()
                               ? std::string("; name its columns with --columns x=N,y=N,z=N or "
                                             "lon=N,lat=N,height=N (")
                               : "; say which is which, perhaps with --columns " + metric +
                                     ", or, of degrees, " + offered_columns(header, true) + " (") +
                          list_columns(table) + ")");
  }
  return missing_column(std::string("there is no header that tells the columns") +
                        (table.columns >= 5
                             ? "; say which is which, for example with --columns "
                               "id=1,time=2,x=3,y=4,z=5, or, where each file is one bee, "
                               "time=1,x=2,y=3,z=4, or frame=1,x=2,y=3,z=4 with --fps N ("
                             : "; needed are columns of numbers for the time, for x and y "
                               "or longitude and latitude, and perhaps for an id and the "
                               "height; name them in a header or with --columns (") +
                        list_columns(table) + ")");
}

Error with_position_problem(Error time, std::string_view text, const Header& header) {
  if (time.code != ErrorCode::kInvalidArgument || header.table().names.empty()) return time;
  auto position = joined_place_of(header) ? std::nullopt : nameless_position(text, header);
  if (!position) return time;
  const bool in_one = place_in_one_value(text, header.table(), JsonFrom::kFile).has_value();
  if (!in_one && !position->message.starts_with("the header names no position")) return time;
  position->message += "; and " + time.message;
  return *std::move(position);
}

}  // namespace beespace::io
