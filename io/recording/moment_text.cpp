#include "io/recording/moment_text.hpp"

#include "io/bytes/number_text.hpp"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace beespace::io {
namespace {

constexpr double kFarthest_s = 1e11;

// Date and time of a clock, in seconds since 1970-01-01 00:00:00 on it; the date with this behind.
std::string date_and_time(double local_s, char between) {
  using std::chrono::floor;
  // Rounded first, so that 59.9996 s become the next minute.
  const double rounded_s = std::round(local_s * 1e3) / 1e3;
  const double whole = std::floor(rounded_s);
  const std::chrono::sys_seconds seconds{std::chrono::seconds(static_cast<std::int64_t>(whole))};
  const auto day = floor<std::chrono::days>(seconds);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss time{seconds - day};
  char text[40];
  std::snprintf(text, sizeof text, "%04d-%02u-%02u%c%02d:%02d:%06.3f", int{date.year()},
                unsigned{date.month()}, unsigned{date.day()}, between,
                static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
                static_cast<double>(time.seconds().count()) + (rounded_s - whole));
  return text;
}

// Of a clock that shows UTC, or the time of a zone, at an instant.
std::string instant_text(double since_1970_s, const TimeZone& zone) {
  const double rounded_s = std::round(since_1970_s * 1e3) / 1e3;
  const std::int64_t offset_s = zone.offset_at(static_cast<std::int64_t>(std::floor(rounded_s)));
  return date_and_time(since_1970_s + static_cast<double>(offset_s), 'T') + offset_text(offset_s);
}

}  // namespace

std::string utc_text(double since_1970_s) {
  return std::abs(since_1970_s) < kFarthest_s ? instant_text(since_1970_s, TimeZone::utc())
                                              : std::string();
}

std::string Calendar::text(double time_s) const {
  if (!(std::abs(time_s) < kFarthest_s)) return {};
  if (since_1970) return instant_text(time_s, zone ? *zone : TimeZone::utc());
  if (!clock) return {};
  constexpr std::size_t kBeforeTime = 11;  // "1970-01-01 "
  std::string text = date_and_time(time_s + static_cast<double>(clock->zero_s), ' ');
  return clock->dated ? text : text.substr(kBeforeTime);
}

double Calendar::shown_s(double time_s) const {
  if (since_1970) {
    if (!zone || !(std::abs(time_s) < kFarthest_s)) return time_s;
    const double rounded_s = std::round(time_s * 1e3) / 1e3;
    return time_s +
           static_cast<double>(zone->offset_at(static_cast<std::int64_t>(std::floor(rounded_s))));
  }
  return clock ? time_s + static_cast<double>(clock->zero_s) : time_s;
}

bool Calendar::is_local() const {
  return since_1970 && zone && (zone->is_turned() || zone->offset_at(0) != 0);
}

Calendar calendar_of(const Recording& recording) {
  return {recording.since_1970, recording.time_zone, recording.clock};
}

std::string clock_text(const Recording& recording) {
  if (recording.since_1970) return "seconds since 1970-01-01T00:00:00Z";
  if (!recording.clock) return "seconds";
  if (!recording.clock->dated) return "seconds since midnight, of a day that is not known";
  const std::string zero = date_and_time(static_cast<double>(recording.clock->zero_s), ' ');
  return "seconds since " + zero.substr(0, zero.find('.')) +
         " of a clock whose time zone is not known";
}

std::string moment_text(double time_s, const Recording& recording) {
  const std::string date = calendar_of(recording).text(time_s);
  return date.empty() ? grouped(time_s, 2) + " s" : date;
}

}  // namespace beespace::io
