#include "io/tracks/record_numbers.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/unplaced.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/header_words.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_record.hpp"
#include "io/tracks/unclear_id.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_set>
#include <vector>

namespace beespace::io {
namespace {

// How many records there are where each has an id of its own and not all are of one time; 0
// otherwise. Most tables tell that at their second bee.
std::size_t count_numbered(std::string_view text, const TrackLayout& layout) {
  TrackRecordReader reader(layout);
  TrackRecord record;
  std::unordered_set<std::string> ids;
  std::optional<double> first_s;
  bool several_times = false;
  RecordWalk walk(text, layout.table.data_offset, layout.table);
  while (walk.next()) {
    if (reader.read(walk.record(), record)) continue;
    if (record.left_out == nullptr) {
      several_times = several_times || (first_s && *first_s != record.time_s);
      first_s = record.time_s;
    }
    if (record.left_out != nullptr && record.left_out == layout.without_id) continue;
    if (!ids.insert(std::string(record.id) + '\0' + std::string(record.set)).second) return 0;
  }
  return several_times ? ids.size() : 0;
}

// Whether its values repeat and are no measures: twice each, on average, in the first records.
bool repeats(std::string_view text, const TableLayout& table, std::size_t column) {
  constexpr std::size_t kMostLookedAt = 20'000;
  std::unordered_set<std::string> values;
  std::size_t records = 0;
  RecordWalk walk(text, table.data_offset, table);
  while (walk.next() && records < kMostLookedAt) {
    const Field field = field_at(walk.record(), table.delimiter, column);
    const std::string value(without_padding(unquoted(field)));
    if (is_unknown(value)) continue;
    double number = 0.0;
    if (parse_number(value, number) == NumberKind::kNumber && number != std::floor(number)) {
      return false;
    }
    ++records;
    values.insert(value);
  }
  return records > 1 && 2 * values.size() <= records;
}

// Those that are called an id first.
std::vector<std::size_t> other_ids(std::string_view text, const Header& header,
                                   const TrackLayout& layout) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (may_hold_ids(header, layout, i) && repeats(text, layout.table, i)) found.push_back(i);
  }
  std::stable_partition(found.begin(), found.end(), [&header](std::size_t column) {
    return header.meaning(column).role == Role::kId;
  });
  return found;
}

}  // namespace

std::optional<Error> numbered_records(std::string_view text, const Header& header,
                                      const TrackLayout& layout) {
  constexpr std::size_t kMostNamed = 4;
  const TableLayout& table = layout.table;
  const auto& id = table.choice.id;
  if (!id || !layout.time || header.override_of(Role::kId)) return std::nullopt;
  // An address may be heard once.
  if (*id < table.names.size() && speaks_of_aviation(table.names[*id])) return std::nullopt;
  const std::size_t records = count_numbered(text, layout);
  if (records < kFewestNumbered) return std::nullopt;
  const std::vector<std::size_t> others = other_ids(text, header, layout);
  // Each may have been heard once, and the velocity tells the rest.
  if (others.empty() && layout.velocity) return std::nullopt;
  const auto say = [](std::size_t column) { return "--columns id=" + std::to_string(column + 1); };
  std::string message =
      "which column is the id? By " + column_text(table, *id) + " each of the " +
      grouped(std::uint64_t{records}) +
      " records, which are of several times, is of another bee, as if it numbered "
      "the records";
  if (others.empty()) {
    message +=
        "; if all are of one bee, or the bees are told by the names of files, take that column out";
  }
  for (std::size_t i = 0; i < std::min(kMostNamed, others.size()); ++i) {
    message += i == 0 ? "; say " : " or ";
    message += say(others[i]) + " for " + excerpt(table.names[others[i]]);
  }
  return Error{ErrorCode::kMissingColumn,
               message + "; if each is of another bee after all, say " + say(*id),
               {}};
}

}  // namespace beespace::io
