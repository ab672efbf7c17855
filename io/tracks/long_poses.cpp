#include "io/tracks/long_poses.hpp"

#include "io/bytes/characters.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/record_walk.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::size_t kMostPlaces = 20;

std::vector<std::string> places_named(std::string_view text, const TableLayout& table,
                                      std::size_t column) {
  constexpr std::size_t kMostLookedAt = 5000;
  std::vector<std::string> places;
  RecordWalk walk(text, table.data_offset, table);
  for (std::size_t i = 0; i < kMostLookedAt && walk.next() && places.size() <= kMostPlaces; ++i) {
    const Field field = field_at(walk.record(), table.delimiter, column);
    const std::string_view name = without_padding(field.text);
    if (name.empty() || std::find(places.begin(), places.end(), name) != places.end()) continue;
    places.emplace_back(name);
  }
  return places;
}

// Whether it means itself between quotes of awk and of a shell.
bool is_plain_name(std::string_view name) {
  return std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == ' ';
  });
}

// "awk -F, 'NR==1||$3==\"head\"' FILE > head.csv".
std::string awk_line(const TableLayout& table, std::size_t column, const std::string& place) {
  const std::string separator = table.delimiter == '\t'  ? "'\\t'"
                                : table.delimiter == ' ' ? "' '"
                                                         : std::string("'") + table.delimiter + "'";
  return "awk -F" + separator + " 'NR==1||$" + std::to_string(column + 1) + "==\"" + place +
         "\"' FILE > one.csv";
}

}  // namespace

std::optional<Error> which_place_of_body(std::string_view text, const TableLayout& table,
                                         const RecordingOptions& options) {
  const auto named = std::find_if(table.names.begin(), table.names.end(), [](const auto& name) {
    return is_one_of("bodypart bodyparts body_part body_parts keypoint key_point node node_name",
                     plain_name(name));
  });
  if (named == table.names.end()) return std::nullopt;
  const auto column = static_cast<std::size_t>(named - table.names.begin());
  const std::vector<std::string> places = places_named(text, table, column);
  if (places.size() < 2 || !std::all_of(places.begin(), places.end(), is_plain_name)) {
    return std::nullopt;
  }
  std::string list;
  for (std::size_t i = 0; i < std::min(places.size(), kMostPlaces); ++i) {
    list.append(i == 0 ? "" : ", ").append(excerpt(places[i]));
  }
  if (places.size() > kMostPlaces) list += ", ...";
  std::string message = column_text(table, column) + " names several places of a body (" + list +
                        "), and one of them is where the animal is: take its rows, as by " +
                        awk_line(table, column, places.front()) + ", and read one.csv";
  if (!options.frames_per_second) message += ", with --fps 25 for so many pictures a second";
  if (!options.pixel) {
    message += std::string(options.frames_per_second ? ", with" : " and") +
               " --scale 0.1mm for so long a pixel";
  }
  return Error{ErrorCode::kInvalidArgument, std::move(message), {}};
}

}  // namespace beespace::io
