#include "io/tracks/wall_times.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/table_sources.hpp"
#include "io/tracks/date_order.hpp"
#include "io/units/iso_time.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace beespace::io {
namespace {

// In names of columns, between others.
constexpr std::array<std::string_view, 7> kClockZones = {
    "_timezone_", "_time_zone_", "_tz_", "_tzone_", "_utc_offset_", "_gmt_offset_", "_zeitzone_"};

bool looks_like_date(std::string_view text) {
  return looks_like_iso_time(text) || looks_like_other_date(text) || looks_like_named_month(text);
}

// "UTC_datetime", "time (GMT)"; not "time (UTC+2)".
bool names_utc(const std::string& name) {
  bool utc = false;
  for (const std::string& word : split_words(name)) {
    if (is_one_of("utc gmt", word)) {
      utc = true;
    } else if (!is_one_of(
                   "date time datetime timestamp datum zeit fecha hora acq acquisition fix gps",
                   word)) {
      return false;
    }
  }
  return utc && name.find_first_of("+-") == std::string::npos;
}

bool names_local(const Header& header, std::size_t column) {
  return column < header.size() && names_local_time(header.table().names[column]);
}

// Which zone dates and times are of that name none: UTC where a known source or the header says so,
// whichever zone the caller names for others; else that one.
void choose_zone(const Header& header, const RecordingOptions& options, TimeChoice& time) {
  const TableSource* const source = source_of(header.table().names);
  if (source != nullptr && source->in_utc && !names_local(header, time.column)) {
    time.zone = TimeZone::utc();
    time.zone_reason = "the header is that of " + std::string(source->name);
  } else if (time.column < header.size() && names_utc(header.table().names[time.column])) {
    time.zone = TimeZone::utc();
    time.zone_reason = "the header says it";
  } else if (header.table().titles_say_utc && !names_local(header, time.column)) {
    time.zone = TimeZone::utc();
    time.zone_reason = "a line above the header says it";
  } else if (options.time_zone) {
    time.zone = options.time_zone;
    time.zone_reason = "as --time-zone says";
  }
}

// Clocks of a place are turned, or those of several places are not one.
std::optional<Error> zone_of_place_problem(const Header& header, const TimeChoice& time) {
  if (!time.clock || !time.clock->dated || !names_local(header, time.column)) return std::nullopt;
  if (find_clock_zone(header.table())) return std::nullopt;
  return at_column(ErrorCode::kInvalidArgument,
                   column_text(header.table(), time.column) +
                       " is of the clocks of a place, but of which? Say it with --time-zone, as in "
                       "--time-zone Europe/Madrid, or by what they are ahead of UTC, as in "
                       "--time-zone +02:00",
                   time.column);
}

bool may_say_day(const std::string& name) {
  const std::vector<std::string> words = split_words(name);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return is_one_of("date day datum fecha jour dia giorno", word);
  });
}

// Beside times of day, the column of the day, if it is not certain which it is or whether it is
// one.
std::optional<Error> doubtful_day(std::string_view text, const Header& header,
                                  const TimeChoice& time) {
  const TableLayout& table = header.table();
  for (std::size_t i = 0; i < table.columns; ++i) {
    if (i == time.column || header.override_of(Role::kId) == i) continue;
    const bool named =
        i < header.size() && (header.meaning(i).role == Role::kDate || may_say_day(table.names[i]));
    const FirstFields fields = first_fields(text, table, i);
    const bool day = !fields.empty() && looks_like_date(fields.front());
    if (!named && !day) continue;
    return missing_column(
        "times of day are read from " + column_text(table, time.column) + ", and " +
        column_text(table, i) +
        " may hold their day; say so with --columns date=" + std::to_string(i + 1) +
        ", or, if it has nothing to do with them, leave it out of the table");
  }
  return std::nullopt;
}

constexpr std::size_t kToTheSecond = std::string_view("2024-05-01 12:00:00").size();

bool say_the_same(const FirstFields& some, const FirstFields& others) {
  return std::equal(some.texts.begin(), some.texts.end(), others.texts.begin(), others.texts.end(),
                    [](std::string_view a, std::string_view b) {
                      return a.substr(0, kToTheSecond) == b.substr(0, kToTheSecond);
                    });
}

// Whether the times are dates, times of day or numbers.
std::optional<Error> choose_form(std::string_view text, const Header& header,
                                 const FirstFields& times, TimeChoice& time) {
  if (times.empty()) return std::nullopt;
  if (looks_like_date(times.front())) {
    time.form = TimeForm::kDatesAndTimes;
    return std::nullopt;
  }
  const bool minutes = looks_like_hours_and_minutes(times.front());
  if (!minutes && !looks_like_clock(times.front())) return std::nullopt;
  time.form = TimeForm::kClock;
  time.date =
      header.override_of(Role::kDate) ? header.override_of(Role::kDate) : header.only(Role::kDate);
  if (time.date) return std::nullopt;
  if (auto error = doubtful_day(text, header, time)) return error;
  if (!minutes) return std::nullopt;
  return not_a("time", times,
               "without a date it may be hours and minutes, or minutes and seconds; write it as "
               "07:30:00");
}

bool has_time(std::string_view text) {
  return text.find(':') != std::string_view::npos;
}

// R writes midnight as a day alone: the first field with a time of day, or the first of all.
std::string_view first_with_time(const FirstFields& fields) {
  const auto found = std::find_if(fields.texts.begin(), fields.texts.end(), has_time);
  return found == fields.texts.end() ? fields.front() : *found;
}

// Of dates and times, or times of day: whether they are instants, or else what they count from.
std::optional<Error> settle_wall_times(std::string_view text, const TableLayout& table,
                                       const FirstFields& times, DateOrder asked,
                                       TimeChoice& time) {
  WallTime first;
  const bool clock = time.form == TimeForm::kClock;
  const std::size_t dates = time.date.value_or(time.column);
  const bool has_dates = !clock || time.date.has_value();
  const FirstFields first_dates = first_fields(text, table, dates);
  if (has_dates && !first_dates.empty() && !looks_like_iso_time(first_dates.front())) {
    auto order = choose_date_order(text, table, dates, asked);
    if (!order) return order.error();
    time.dates = order->order;
    time.dates_reason = std::move(order->reason);
  }
  const std::string_view with_time = first_with_time(times);
  const std::string_view problem =
      clock ? parse_clock(times.front(), first) : parse_wall_time(with_time, first, time.dates);
  time.bare_midnights = !clock && !time.date && has_time(with_time);
  if (!problem.empty()) {
    return not_a("time", times, problem);
  }
  std::int64_t day_s = first.seconds - (first.seconds % 86'400 + 86'400) % 86'400;
  if (time.date) {
    const auto days = first_fields(text, table, *time.date);
    if (days.empty()) {
      return at_column(ErrorCode::kNotANumber,
                       column_text(table, *time.date) +
                           ", the day of the times, is empty; fill it in, or leave it out of the "
                           "table",
                       *time.date);
    }
    const std::string_view what = parse_day(days.front(), day_s, time.dates);
    if (!what.empty()) {
      return not_a("date", days,
                   std::string(what) + "; if it is no day, leave that column out of the table");
    }
  }
  const std::size_t colon = with_time.find(':');
  time.to_the_minute = with_time.find(':', colon + 1) == std::string_view::npos;
  const bool dated = !clock || time.date;
  time.since_1970 = dated && (first.offset_s || time.zone);
  if (time.since_1970) return std::nullopt;
  time.clock = WallClock{dated, dated ? day_s : 0};
  return std::nullopt;
}

}  // namespace

bool names_local_time(std::string_view column) {
  const auto words = split_words(column);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word == "lmt" || word.starts_with("local");
  });
}

bool is_date_with_time(const FirstFields& fields) {
  return !fields.empty() && looks_like_date(fields.front()) && has_time(first_with_time(fields));
}

std::optional<std::size_t> only_dated(std::string_view text, const TableLayout& table,
                                      const std::vector<std::size_t>& columns) {
  std::optional<std::size_t> chosen;
  FirstFields dated;
  bool needs_fraction = false;  // which a column beside has
  for (const std::size_t column : columns) {
    FirstFields fields = first_fields(text, table, column);
    if (!is_date_with_time(fields)) {
      const bool fraction = plain_name(table.names[column]) == "milliseconds";
      if (!fraction && (fields.empty() || !looks_like_clock(fields.front()))) return std::nullopt;
      needs_fraction = needs_fraction || fraction;
      continue;
    }
    if (chosen && !say_the_same(dated, fields)) return std::nullopt;
    // The one with fractions of seconds.
    if (chosen && fields.front().size() <= dated.front().size()) continue;
    chosen = column;
    dated = std::move(fields);
  }
  if (needs_fraction && chosen && dated.front().size() <= kToTheSecond) return std::nullopt;
  return chosen;
}

std::optional<Error> choose_wall_times(std::string_view text, const Header& header,
                                       const FirstFields& times, const RecordingOptions& options,
                                       TimeChoice& time) {
  if (auto error = choose_form(text, header, times, time)) return error;
  if (time.form == TimeForm::kNumbers) return std::nullopt;
  choose_zone(header, options, time);
  auto error = settle_wall_times(text, header.table(), times, options.dates, time);
  return error ? error : zone_of_place_problem(header, time);
}

bool is_day_alone(std::string_view text, DateOrder order) {
  std::int64_t day_s = 0;
  return text.find(':') == std::string_view::npos && parse_day(text, day_s, order).empty();
}

bool says_midnight(std::string_view text) {
  const std::size_t time = text.find_first_of("T ");
  return time != std::string_view::npos && text.substr(time + 1).starts_with("00:00") &&
         text.find_first_of("123456789+-", time) == std::string_view::npos;
}

std::string read_wall_time(const TimeChoice& time, std::string_view text, std::string_view day,
                           double& seconds, double& again_after_s) {
  again_after_s = 0.0;
  WallTime wall;
  const bool clock = time.form == TimeForm::kClock;
  const std::string_view problem =
      clock ? parse_clock(text, wall) : parse_wall_time(text, wall, time.dates);
  if (!problem.empty()) return std::string(problem);
  if (time.date) {
    std::int64_t day_s = 0;
    const std::string_view what = parse_day(day, day_s, time.dates);
    if (!what.empty()) return "the day " + excerpt(day) + ": " + std::string(what);
    wall.seconds += day_s;
  }
  if (time.clock) {
    if (wall.offset_s && time.clock->dated) {
      return "it has a time zone, but the first times have none; say with --time-zone which they "
             "are of";
    }
    seconds = seconds_after(wall, time.clock->zero_s);
    return {};
  }
  std::int64_t offset_s = 0;
  if (wall.offset_s) {
    offset_s = *wall.offset_s;
  } else if (!time.zone) {
    return "it has no time zone; write Z for UTC behind it, or an offset such as +02:00, or say "
           "with --time-zone which it is";
  } else if (std::string what = time.zone->offset_of_local(wall.seconds, offset_s); !what.empty()) {
    again_after_s = static_cast<double>(time.zone->shown_again_after(wall.seconds));
    seconds = seconds_after(wall, offset_s);
    return what;
  }
  seconds = seconds_after(wall, offset_s);
  return {};
}

std::optional<std::size_t> find_clock_zone(const TableLayout& table) {
  const auto found =
      std::find_if(table.names.begin(), table.names.end(), [](const std::string& name) {
        const std::string joined = "_" + plain_name(name) + "_";
        return std::any_of(kClockZones.begin(), kClockZones.end(), [&](std::string_view words) {
          return joined.find(words) != std::string::npos;
        });
      });
  if (found == table.names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.names.begin());
}

std::string dates_note(const TimeChoice& time) {
  std::string text;
  if (time.dates != DateOrder::kUnsaid) {
    text += time.dates == DateOrder::kDayFirst ? ", the day first (" : ", the month first (";
    text += time.dates_reason + ")";
  }
  if (time.to_the_minute) text += ", without seconds, which are taken for 0";
  return text;
}

}  // namespace beespace::io
