#include "io/tracks/track_time.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/table_sources.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/units/iso_time.hpp"

#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// The times of the first records, those that are there.
std::vector<std::string_view> first_times(std::string_view text, const TableLayout& table,
                                          std::size_t column) {
  constexpr int kLookedAt = 16;
  std::vector<std::string_view> times;
  std::size_t offset = table.data_offset;
  for (int i = 0; i < kLookedAt && offset < text.size(); ++i) {
    const Line line = line_at(text, offset, table.line_end);
    offset = line.next;
    if (line.text.size() > kLongestLine) continue;
    const auto time = without_padding(field_at(line.text, table.delimiter, column).text);
    if (!is_unknown(time)) times.push_back(time);
  }
  return times;
}

// The unit in which all of them are times since 1970; kUnstated where there is none.
Unit common_unit(const std::vector<std::string_view>& times) {
  Unit common = Unit::kUnstated;
  for (const std::string_view time : times) {
    double value = 0.0;
    if (parse_number(time, value) != NumberKind::kNumber) return Unit::kUnstated;
    const Unit unit = unit_since_1970(value);
    if (unit == Unit::kUnstated || (common != Unit::kUnstated && unit != common)) {
      return Unit::kUnstated;
    }
    common = unit;
  }
  return common;
}

// A time of aircraft that counts from 1970 tells its unit by its size; where no aircraft is spoken
// of, microseconds since a boot may look the same.
Result<TimeChoice> choose_unit(TimeChoice time, const ColumnMeaning& meaning,
                               const std::vector<std::string_view>& times, const TableLayout& table,
                               Unit asked) {
  if (time.iso) {
    time.since_1970 = true;
    return time;
  }
  time.since_1970 = meaning.since_1970;
  time.unit = asked != Unit::kUnstated ? asked : if_unit_of(meaning.unit, Quantity::kTime);
  if (asked == Unit::kUnstated && !meaning.foreign_unit.empty()) {
    return at_column(ErrorCode::kUnsupportedFormat,
                     column_text(table, time.column) + " is in '" + meaning.foreign_unit +
                         "'; convert it first: beespace reads s, ms, us, ns and dates of ISO 8601",
                     time.column);
  }
  const Unit by_size = common_unit(times);
  if (time.unit == Unit::kUnstated && !words_of_aviation(table.names).empty()) {
    time.unit = by_size;
    time.by_size = by_size != Unit::kUnstated;
  }
  time.since_1970 = time.since_1970 || (by_size != Unit::kUnstated && by_size == time.unit);
  if (time.unit == Unit::kUnstated) {
    return at_column(ErrorCode::kInvalidArgument,
                     column_text(table, time.column) +
                         " holds the time, but in which unit? Say it with --time-unit s, ms, us "
                         "or ns, or in the header: time_s",
                     time.column);
  }
  return time;
}

}  // namespace

Unit unit_since_1970(double value) {
  constexpr double kEarliest_s = 5e8;
  constexpr double kLatest_s = 5e9;
  for (const Unit unit :
       {Unit::kSecond, Unit::kMillisecond, Unit::kMicrosecond, Unit::kNanosecond}) {
    const double seconds = in_metric(value, unit);
    if (seconds >= kEarliest_s && seconds < kLatest_s) return unit;
  }
  return Unit::kUnstated;
}

Result<std::optional<TimeChoice>> choose_time(std::string_view text, const Header& header,
                                              Unit asked) {
  const TableLayout& table = header.table();
  std::optional<std::size_t> column = header.override_of(Role::kTime);
  const ColumnMeaning meaning = column ? header.stated(*column) : ColumnMeaning();
  const std::vector<std::size_t>& found = header.columns(Role::kTime);
  if (!column && found.size() > 1) {
    return missing_column(
        "both " + column_text(table, found[0]) + " and " + column_text(table, found[1]) +
        " look like the time; say which with --columns "
        "time=" +
        std::to_string(found[0] + 1) + " or time=" + std::to_string(found[1] + 1));
  }
  if (!column && found.empty()) return std::optional<TimeChoice>();
  TimeChoice time;
  time.column = column ? *column : found.front();
  const std::vector<std::string_view> times = first_times(text, table, time.column);
  time.iso = !times.empty() && looks_like_iso_time(times.front());
  auto chosen =
      choose_unit(time, column ? meaning : header.meaning(time.column), times, table, asked);
  if (!chosen) return chosen.error();
  return std::optional<TimeChoice>(chosen.value());
}

std::string time_note(const TableLayout& table, const TimeChoice& time, bool asked) {
  std::string text = "times are read from " + column_text(table, time.column);
  if (time.iso) return text + " as dates and times (ISO 8601)";
  text += " in " + std::string(symbol_of(time.unit));
  if (asked) text += ", as asked for";
  if (time.since_1970) text += ", since 1970";
  return text + (time.by_size ? ", as their size tells" : "");
}

}  // namespace beespace::io
