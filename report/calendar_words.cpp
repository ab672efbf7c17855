#include "report/calendar_words.hpp"

#include "io/units/time_zone.hpp"
#include "report/number_label.hpp"

#include <cmath>
#include <cstddef>

namespace beespace::report {
namespace {

constexpr double kSecondsADay = 86'400.0;
constexpr std::size_t kDateLength = 10;  // "2024-05-01"

bool knows_days(const io::Calendar& calendar) {
  return calendar.since_1970 || (calendar.clock && calendar.clock->dated);
}

std::string offset_behind(double time_s, const io::Calendar& calendar) {
  if (!calendar.is_local()) return {};
  return io::offset_text(std::llround(calendar.shown_s(time_s) - time_s));
}

}  // namespace

std::string date_time_label(double time_s, const io::Calendar& calendar) {
  if (!calendar.tells()) return {};
  std::string text = instant_label(calendar.shown_s(time_s));
  if (text.empty() || (calendar.since_1970 && !calendar.is_local())) return text;
  text.pop_back();  // the Z of UTC
  if (calendar.since_1970) return text + offset_behind(time_s, calendar);
  text[kDateLength] = ' ';
  return calendar.clock->dated ? text : text.substr(kDateLength + 1);
}

std::string short_moment_label(double time_s, const io::Calendar& calendar, bool with_day) {
  if (!calendar.tells()) return {};
  const double shown_s = std::round(calendar.shown_s(time_s));
  const std::string day = date_label(shown_s);
  if (day.empty()) return {};
  const double midnight = std::floor(shown_s / kSecondsADay) * kSecondsADay;
  std::string text = with_day && knows_days(calendar) ? day.substr(5) + " " : std::string();
  text += clock_label(shown_s - midnight, 1.0);
  return text += offset_behind(time_s, calendar);
}

}  // namespace beespace::report
