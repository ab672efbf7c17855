// Times as ISO 8601 writes them: "2024-05-01T12:00:00.25Z", "2024-05-01 14:00:00,25+02:00"; dates
// also with slashes or points, "2024/05/01", or with the year last, "27.10.2024", where their order
// is known, or with the month by its name, "15-Jan-2024", perhaps behind the time.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace beespace::io {

// Of dates whose year is last.
enum class DateOrder : std::uint8_t { kUnsaid, kDayFirst, kMonthFirst };

// What a date whose year is last tells of that: by points the day is first; "27/10/2024" can have
// no other order; "05/06/2024" leaves it unsaid. Nothing where it is no such date.
std::optional<DateOrder> order_told_by(std::string_view text);

// Whether the text begins as a date does, so that it is no number.
bool looks_like_iso_time(std::string_view text);

// Whether it begins with a date, written so or not: "10.09.2015 07:00", "9/10/15", "2015.9.10".
bool looks_like_other_date(std::string_view text);

// Whether it begins with a date whose month is named, perhaps behind the time of day:
// "15-Jan-2024 07:00:00", "07:00:00 15-Jan-2024".
bool looks_like_named_month(std::string_view text);

// Whether it begins as a time of day does, alone: "07:00:00", "7:00:00.5".
bool looks_like_clock(std::string_view text);

// Whether it is all of "07:30": hours and minutes, or minutes and seconds. "7:30 PM", too.
bool looks_like_hours_and_minutes(std::string_view text);

// What a clock shows.
struct WallTime {
  std::int64_t seconds = 0;  // since 1970-01-01 00:00:00 on that clock, or since midnight
  std::int64_t nanos = 0;
  std::optional<std::int64_t> offset_s = {};  // ahead of UTC, where it says so
};

// Date, and time, perhaps without seconds; behind them perhaps "AM" or "PM", and "Z", "UTC" or an
// offset. Returns what is wrong, as a sentence; nothing when all is well.
std::string_view parse_wall_time(std::string_view text, WallTime& time,
                                 DateOrder order = DateOrder::kUnsaid);
// A time of day alone, since midnight.
std::string_view parse_clock(std::string_view text, WallTime& time);
// A day alone, in seconds since 1970-01-01 00:00:00.
std::string_view parse_day(std::string_view text, std::int64_t& seconds,
                           DateOrder order = DateOrder::kUnsaid);
// "Z", "+02:00", "-0330": minutes east of Greenwich.
std::string_view parse_offset(std::string_view text, int& minutes);

// So many whole seconds later than `from_s`, and its fraction: the nearest double.
double seconds_after(const WallTime& time, std::int64_t from_s);

// Seconds since 1970-01-01T00:00:00Z, of which each day has 86,400: the nearest double. Date, time
// and "Z" or an offset must all be there; the fraction may have any length, of which
// nine digits are read. Returns what is wrong, as a sentence; nothing when all is well.
std::string_view parse_iso_time(std::string_view text, double& seconds);

}  // namespace beespace::io
