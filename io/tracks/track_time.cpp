#include "io/tracks/track_time.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"
#include "io/table/header_words.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/dated_numbers.hpp"
#include "io/tracks/excel_days.hpp"
#include "io/tracks/fine_time.hpp"
#include "io/tracks/first_fields.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/unread_times.hpp"
#include "io/tracks/wall_times.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// ---- Seconds and nanoseconds in two columns -----------------------------------------------------

struct Stamp {
  std::size_t seconds = 0;
  std::size_t nanoseconds = 0;
  bool of_header = false;  // "header.stamp.sec": when it was measured, not when it was recorded
};

// "header.stamp" of "header.stamp.sec", if the last word is one of these; otherwise nothing.
std::optional<std::string> words_before(std::string_view name, std::string_view last) {
  std::vector<std::string> words = split_words(name);
  if (words.empty() || !is_one_of(last, words.back())) return std::nullopt;
  words.pop_back();
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ".") + word;
  return text;
}

std::vector<Stamp> stamps_in(const TableLayout& table) {
  std::vector<Stamp> stamps;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const auto before = words_before(table.names[i], "sec secs second seconds");
    for (std::size_t j = 0; before && j < table.names.size(); ++j) {
      const auto same =
          words_before(table.names[j], "nanosec nanosecs nsec nsecs nanosecond nanoseconds");
      if (same == before)
        stamps.push_back({i, j, before->find("header.stamp") != std::string::npos});
    }
  }
  return stamps;
}

// The one to take: of several that of the header.
Result<std::optional<Stamp>> choose_stamp(const Header& header) {
  std::vector<Stamp> stamps = stamps_in(header.table());
  const std::optional<std::size_t>& asked = header.override_of(Role::kTime);
  if (asked) {
    std::erase_if(stamps, [&](const Stamp& stamp) { return stamp.seconds != *asked; });
  } else if (stamps.size() > 1) {
    std::vector<Stamp> of_header = stamps;
    std::erase_if(of_header, [](const Stamp& stamp) { return !stamp.of_header; });
    if (of_header.size() == 1) stamps = std::move(of_header);
  }
  if (stamps.empty()) return std::optional<Stamp>();
  if (stamps.size() == 1) return std::optional<Stamp>(stamps.front());
  return missing_column("both " + column_text(header.table(), stamps[0].seconds) + " and " +
                        column_text(header.table(), stamps[1].seconds) +
                        " look like the seconds of the time; say which with --columns time=" +
                        std::to_string(stamps[0].seconds + 1) +
                        " or time=" + std::to_string(stamps[1].seconds + 1));
}

Result<TimeChoice> time_of_stamp(const Stamp& stamp, std::string_view text, const Header& header,
                                 Unit asked) {
  if (asked != Unit::kUnstated && asked != Unit::kSecond) {
    return Error{ErrorCode::kInvalidArgument,
                 "the times are in seconds and nanoseconds, in " +
                     column_text(header.table(), stamp.seconds) + " and " +
                     column_text(header.table(), stamp.nanoseconds) +
                     "; leave --time-unit out, or, where several files have one clock, say "
                     "--one-clock in its place",
                 {}};
  }
  TimeChoice time;
  time.column = stamp.seconds;
  time.nanoseconds = stamp.nanoseconds;
  const auto times = first_fields(text, header.table(), stamp.seconds);
  time.since_1970 = !times.empty() && common_unit_since_1970(times) == Unit::kSecond;
  for (const std::size_t other : header.columns(Role::kTime)) {
    if (other != stamp.seconds && other != stamp.nanoseconds) time.other = other;
  }
  return time;
}

// ---- One column ---------------------------------------------------------------------------------

// "field.header.stamp": one number, nanoseconds since 1970, beside the time of the recording.
bool is_header_stamp(std::string_view name) {
  const std::vector<std::string> words = split_words(name);
  return words.size() >= 2 && words[words.size() - 2] == "header" && words.back() == "stamp";
}

// Of which ROS's tables alone have such columns.
bool is_of_ros(std::string_view name) {
  const std::vector<std::string> words = split_words(name);
  const auto has = [&words](std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  return has("header") && has("stamp");
}

// What says "utc", or "local_time", is the time where no other column is, the first before the
// second: they are taken out of `found` otherwise. One that was.
std::optional<std::size_t> take_faint(const TableLayout& table, std::vector<std::size_t>& found) {
  const auto faintness = [&table](std::size_t column) {
    const std::string& name = table.names[column];
    if (names_local_time(name)) return 2;
    return is_one_of("utc gmt", plain_name(name)) ? 1 : 0;
  };
  int least = 2;
  for (const std::size_t column : found) least = std::min(least, faintness(column));
  std::optional<std::size_t> taken;
  std::erase_if(found, [&](std::size_t column) {
    const bool faint = faintness(column) > least;
    if (faint && !taken) taken = column;
    return faint;
  });
  return taken;
}

// Not "1718000000.0", as pandas writes whole numbers beside ones that are missing.
bool have_fractions(const FirstFields& times) {
  return std::any_of(times.texts.begin(), times.texts.end(), [](std::string_view text) {
    const std::size_t point = text.find('.');
    return point != std::string_view::npos &&
           text.find_first_of("123456789", point) != std::string_view::npos;
  });
}

// The client of Crazyflie logs whole milliseconds beside its estimate, since that was switched on.
bool has_estimate_of_crazyflie(const TableLayout& table) {
  return std::any_of(table.names.begin(), table.names.end(), [](const std::string& name) {
    return plain_name(name).starts_with("stateestimate");
  });
}

// Of units of time: the finer, the more.
std::size_t fineness(Unit unit) {
  constexpr std::array kUnits = {Unit::kSecond, Unit::kMillisecond, Unit::kMicrosecond,
                                 Unit::kNanosecond};
  const auto* const found = std::find(kUnits.begin(), kUnits.end(), unit);
  return static_cast<std::size_t>(found - kUnits.begin());
}

// A finer unit, since 1970, fits these numbers: in the one that was asked for they are dates tens
// of thousands of years ahead.
Error finer_unit(const TableLayout& table, std::size_t column, Unit by_size) {
  return at_column(ErrorCode::kInvalidArgument,
                   column_text(table, column) + " counts " + std::string(symbol_of(by_size)) +
                       " since 1970, as the size of its numbers tells, and not what --time-unit "
                       "says; leave --time-unit out",
                   column);
}

// A time of aircraft, or of ROS, that counts from 1970 tells its unit by its size, and so does one
// that is `dated` by the others beside it; elsewhere microseconds since a boot may look the same,
// but no nanoseconds since one do, nor what can be milliseconds alone.
Result<TimeChoice> choose_unit(TimeChoice time, const ColumnMeaning& meaning,
                               const FirstFields& times, const TableLayout& table, Unit asked,
                               bool dated) {
  time.since_1970 = meaning.since_1970;
  time.unit = asked != Unit::kUnstated ? asked : if_unit_of(meaning.unit, Quantity::kTime);
  if (asked == Unit::kUnstated && !meaning.foreign_unit.empty()) {
    return at_column(ErrorCode::kUnsupportedFormat,
                     column_text(table, time.column) + " is in '" + meaning.foreign_unit +
                         "'; convert it first: beespace reads s, ms, us, ns and dates of ISO 8601",
                     time.column);
  }
  const Unit by_size = common_unit_since_1970(times);
  if (asked != Unit::kUnstated && by_size != Unit::kUnstated &&
      fineness(by_size) > fineness(asked)) {
    return finer_unit(table, time.column, by_size);
  }
  const bool of_ros = std::any_of(table.names.begin(), table.names.end(), is_of_ros);
  // No counter of microseconds has fractions.
  const bool fractions = by_size == Unit::kSecond && have_fractions(times);
  const bool milliseconds = by_size == Unit::kMillisecond && are_surely_milliseconds(times);
  const bool tells = meaning.since_1970 || dated || of_ros || fractions ||
                     by_size == Unit::kNanosecond || milliseconds ||
                     !words_of_aviation(table.names).empty();
  if (time.unit == Unit::kUnstated && tells) {
    time.unit = by_size;
    time.by_size = by_size != Unit::kUnstated;
  }
  if (time.unit == Unit::kUnstated && has_estimate_of_crazyflie(table) && !have_fractions(times)) {
    time.unit = Unit::kMillisecond;
  }
  time.since_1970 = time.since_1970 || (by_size != Unit::kUnstated && by_size == time.unit);
  time.unit_is_asked = asked != Unit::kUnstated && by_size == Unit::kUnstated &&
                       if_unit_of(meaning.unit, Quantity::kTime) == Unit::kUnstated;
  time.named = asked == Unit::kUnstated && !time.since_1970;
  double number = 0.0;
  if (time.unit == Unit::kUnstated && !times.empty() && !is_unknown(times.front()) &&
      parse_number(times.front(), number) == NumberKind::kNotANumber) {
    return unread_time(table, time.column, times);
  }
  if (time.unit == Unit::kUnstated) return which_unit(table, time.column, times);
  if (time.unit_is_asked && may_be_datenums(times)) {
    return unit_of_datenums(table, time.column, times);
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
                                              const RecordingOptions& options) {
  const TableLayout& table = header.table();
  const auto stamp = choose_stamp(header);
  if (!stamp) return stamp.error();
  if (*stamp) {
    auto time = time_of_stamp(**stamp, text, header, options.time_unit);
    if (!time) return time.error();
    return std::optional<TimeChoice>(time.value());
  }
  std::optional<std::size_t> column = header.override_of(Role::kTime);
  const ColumnMeaning meaning = column ? header.stated(*column) : ColumnMeaning();
  std::vector<std::size_t> found = header.columns(Role::kTime);
  std::optional<std::size_t> other;
  if (!column) other = take_faint(table, found);
  if (!column && found.size() == 2) {
    const bool first = is_header_stamp(table.names[found[0]]);
    if (first != is_header_stamp(table.names[found[1]])) {
      other = found[first ? 1 : 0];
      found = {found[first ? 0 : 1]};
    }
  }
  std::optional<std::size_t> measured = header.only(Role::kPositionTime);
  if (column || found.size() > 1) measured.reset();
  if (measured) {
    if (!found.empty()) other = found.front();
    found = {*measured};
  }
  const std::optional<std::size_t> frames = header.override_of(Role::kFrame)
                                                ? header.override_of(Role::kFrame)
                                                : header.only(Role::kFrame);
  TimeChoice time;
  time.of_position = measured.has_value();
  if (frames && !column && (found.empty() || options.frames_per_second)) {
    time.column = *frames;
    time.form = TimeForm::kFrames;
    time.frames_per_second = options.frames_per_second.value_or(0.0);
    return std::optional<TimeChoice>(time);
  }
  if (options.frames_per_second) {
    return Error{ErrorCode::kInvalidArgument,
                 "--fps is given, but no column counts frames; leave it out, or say which does "
                 "with --columns frame=N (" +
                     list_columns(table) + ")",
                 {}};
  }
  bool since_1970 = false;  // as those beside it tell
  if (!column && found.size() > 1) {
    if (const auto dated = only_since_1970(text, header, found)) {
      other = found[found.front() == *dated ? 1 : 0];
      found = {*dated};
      since_1970 = true;
    }
  }
  if (!column && found.size() > 1) {
    // PX4 writes when a message was sent, and when it was measured, which older versions leave 0.
    const auto sample = std::find_if(found.begin(), found.end(), [&table](std::size_t at) {
      return plain_name(table.names[at]) == "timestamp_sample";
    });
    if (found.size() == 2 && sample != found.end() &&
        plain_name(table.names[found[sample == found.begin() ? 1 : 0]]) == "timestamp") {
      other = *sample;
      found.erase(sample);
    } else if (const auto dated = only_dated(text, table, found)) {
      other = found[found.front() == *dated ? 1 : 0];
      found = {*dated};
    }
  }
  if (found.size() == 2 && options.time_unit == Unit::kUnstated) {
    for (const std::size_t dated : found) {
      const std::size_t numbers = found[dated == found[0] ? 1 : 0];
      if (column && dated != *column) continue;
      if (auto fine = find_fine_time(text, header, dated, numbers, options)) return fine;
    }
  }
  // "date", with the time in it.
  const std::optional<std::size_t> date = header.only(Role::kDate);
  if (!column && found.empty() && date) {
    const FirstFields days = first_fields(text, table, *date);
    if (is_date_with_time(days)) {
      found = {*date};
    } else if (may_be_excel_days(days)) {
      return missing_column(
          column_text(table, *date) + " holds numbers, in which unit is not said" +
          std::string(kExcelDaysAdvice) + "; otherwise say the unit, as in --columns time=" +
          std::to_string(*date + 1) + " --time-unit s");
    }
  }
  if (!column && found.size() > 1) {
    return missing_column(
        "both " + column_text(table, found[0]) + " and " + column_text(table, found[1]) +
        " look like the time; say which with --columns "
        "time=" +
        std::to_string(found[0] + 1) + " or time=" + std::to_string(found[1] + 1));
  }
  if (!column && found.empty()) return std::optional<TimeChoice>();
  time.column = column ? *column : found.front();
  time.other = other;
  const FirstFields times = first_fields(text, table, time.column);
  if (auto error = choose_wall_times(text, header, times, options, time)) return *std::move(error);
  if (time.form != TimeForm::kNumbers) return std::optional<TimeChoice>(std::move(time));
  auto chosen = choose_unit(time, column ? meaning : header.meaning(time.column), times, table,
                            options.time_unit, since_1970);
  if (!chosen) return chosen.error();
  return std::optional<TimeChoice>(chosen.value());
}

bool counts_from_start(const TableLayout& table, const TimeChoice& time) {
  if (time.since_1970 || time.form != TimeForm::kNumbers || time.column >= table.names.size()) {
    return false;
  }
  if (has_estimate_of_crazyflie(table) && time.named && time.unit == Unit::kMillisecond)
    return true;
  const auto words = split_words(table.names[time.column]);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return is_one_of("boot uptime", word); });
}

bool times_begin_at_zero(std::string_view text, const TableLayout& table, const TimeChoice& time) {
  if (time.form != TimeForm::kNumbers || time.since_1970) return false;
  const auto is_zero = [&](std::size_t column) {
    const FirstFields fields = first_fields(text, table, column);
    double number = 1.0;
    return !fields.empty() &&
           parse_number(without_padding(fields.front()), number) == NumberKind::kNumber &&
           number == 0.0;
  };
  return is_zero(time.column) && (!time.nanoseconds || is_zero(*time.nanoseconds));
}

bool times_are_small(std::string_view text, const TableLayout& table, const TimeChoice& time) {
  constexpr double kHundredDays_s = 100 * 86'400.0;
  if (time.form != TimeForm::kNumbers || time.since_1970) return false;
  const FirstFields fields = first_fields(text, table, time.column);
  double number = 0.0;
  return !fields.empty() &&
         parse_number(without_padding(fields.front()), number) == NumberKind::kNumber &&
         std::abs(in_metric(number, time.unit)) < kHundredDays_s;
}

std::string time_note(const TableLayout& table, const TimeChoice& time, bool asked) {
  std::string text = "times are read from " + column_text(table, time.column);
  if (time.form == TimeForm::kFrames) {
    return text + " as frames, " + exact(time.frames_per_second) + " a second (--fps)";
  }
  if (time.date) text += " and the day from " + column_text(table, *time.date);
  if (time.clock) {
    text += time.clock->dated ? " as dates and times" : " as times of day of one clock";
    text += dates_note(time);
    return text +
           (time.clock->dated
                ? "; their time zone is not known, so that they are taken for one clock that "
                  "is never turned (--time-zone UTC, or Europe/Madrid, would say which)"
                : "");
  }
  if (time.form != TimeForm::kNumbers) {
    text += " as dates and times";
    if (time.dates == DateOrder::kUnsaid) text += " (ISO 8601)";
    text += dates_note(time);
    if (!time.zone) return text;
    return text + "; those without a time zone are of " + time.zone->name() + ": " +
           time.zone_reason;
  }
  text += " in " + std::string(symbol_of(time.unit));
  if (time.zero_s != 0.0 && time.other) {
    return text + " from the moment on that " + column_text(table, *time.other) +
           " tells to the second";
  }
  if (time.nanoseconds) text += " and " + column_text(table, *time.nanoseconds) + " in ns";
  if (asked) text += ", as asked for";
  if (time.since_1970) text += ", since 1970";
  if (time.by_size) text += ", as their size tells";
  if (!time.other) return text;
  return text + ", not from " + column_text(table, *time.other) +
         "; --columns time=" + std::to_string(*time.other + 1) + " would change that";
}

std::string no_time_text(std::string_view text, const Header& header) {
  std::vector<std::size_t> like;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header.meaning(i).role < Role::kId &&
        resembles(header.schema(), header.table().names[i], Role::kTime)) {
      like.push_back(i);
    }
  }
  if (auto steps = text_of_steps(header.table())) return *std::move(steps);
  const auto names = [&header](std::string_view words) {
    return std::any_of(
        header.table().names.begin(), header.table().names.end(),
        [words](const std::string& name) { return is_one_of(words, plain_name(name)); });
  };
  if (names("hour hours") && names("minute minutes min")) {
    return "the time is in several columns, of days, hours and minutes, which are not read; write "
           "it in one, as 2024-05-01T12:00:00Z (" +
           list_columns(header.table()) + ")";
  }
  std::string which = "time=" + (like.empty() ? "N" : std::to_string(like.front() + 1));
  for (const std::size_t clock : like) {
    const FirstFields times = first_fields(text, header.table(), clock);
    const bool is_clock = !times.empty() && times.front().find(':') < 3;
    if (!is_clock || clock == like.front()) continue;
    which = "date=" + std::to_string(like.front() + 1) + ",time=" + std::to_string(clock + 1);
    break;
  }
  return "there is neither a time nor a velocity; name the column of the time with --columns " +
         which +
         ", or those of the velocity, with which 'beespace predict' needs no time, with vx=N,vy=N"
         " or in the header as 'groundspeed', 'track' and 'vertical_rate'; where all are at one "
         "time, ask 'beespace detect' (" +
         list_columns(header.table()) + ")";
}

}  // namespace beespace::io
