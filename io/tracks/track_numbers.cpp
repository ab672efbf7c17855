#include "io/tracks/track_numbers.hpp"

#include "io/points/record_reading.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/header_words.hpp"
#include "io/table/record_walk.hpp"

#include <unordered_map>
#include <unordered_set>

namespace beespace::io {
namespace {

// Columns that tell apart what 'track' does not: when, and in which arena or trial.
std::vector<std::size_t> columns_of_moment(const Header& header, const TimeChoice& time) {
  std::vector<std::size_t> columns = {time.column};
  if (time.nanoseconds) columns.push_back(*time.nanoseconds);
  if (time.date) columns.push_back(*time.date);
  for (std::size_t i = 0; i < header.size(); ++i) {
    const std::string& name = header.table().names[i];
    if (names_set(name) || names_session(name) || names_scene(name)) columns.push_back(i);
  }
  return columns;
}

// Whether some moment has several records, and none two of one track.
bool tells_apart(std::string_view text, const TableLayout& table, std::size_t track,
                 const std::vector<std::size_t>& moment) {
  constexpr std::uint64_t kMostLookedAt = 5'000;
  std::unordered_map<std::string, std::unordered_set<std::string>> tracks;
  bool any_several = false;
  RecordWalk walk(text, table.data_offset, table);
  while (walk.next() && walk.row() < kMostLookedAt) {
    std::string key;
    for (const std::size_t column : moment) {
      key.append(without_padding(field_at(walk.record(), table.delimiter, column).text));
      key.append(1, '\0');  // no text has it
    }
    auto& of_moment = tracks[key];
    const Field field = field_at(walk.record(), table.delimiter, track);
    if (!of_moment.emplace(without_padding(field.text)).second) return false;
    any_several = any_several || of_moment.size() > 1;
  }
  return any_several;
}

}  // namespace

std::optional<std::size_t> track_numbers(std::string_view text, const Header& header,
                                         const std::optional<TimeChoice>& time,
                                         std::vector<std::string>& notes) {
  const auto track = header.only(Role::kTrack);
  const TableLayout& table = header.table();
  const bool flies = header.has(Role::kGroundSpeed) || header.has(Role::kLongitude) ||
                     !words_of_aviation(table.names).empty();
  if (!track || !time || flies || header.source() != nullptr) return std::nullopt;
  if (!tells_apart(text, table, *track, columns_of_moment(header, *time))) return std::nullopt;
  notes.push_back("ids are read from " + column_text(table, *track) +
                  ", which tells the records of each moment apart");
  return track;
}

}  // namespace beespace::io
