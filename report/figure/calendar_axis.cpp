#include "report/figure/calendar_axis.hpp"

#include "io/units/time_zone.hpp"
#include "report/clock_offsets.hpp"
#include "report/number_label.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::report {
namespace {

constexpr double kADay_s = 86'400.0;

// Of so many seconds since a midnight of the clock.
std::string label_of(double since_s, double midnight_s, double step_s, bool dated) {
  const double day_s = std::floor(since_s / kADay_s) * kADay_s;
  if (dated && day_s > 0.0 && since_s == day_s) return date_label(midnight_s + day_s).substr(5);
  return clock_label(since_s - day_s, step_s);
}

bool has_days(const io::Calendar& calendar) {
  return calendar.since_1970 || (calendar.clock && calendar.clock->dated);
}

// "UTC", "Europe/Madrid, +02:00", "+02:00": the offset where it is the same all the time.
std::string zone_words(const Range& range, const io::Calendar& calendar) {
  if (!calendar.since_1970) return "as in the file";
  if (!calendar.is_local()) return "UTC";
  const auto offsets = clock_offsets(calendar, {range.low, range.high});
  const std::string& name = calendar.zone->name();
  if (!calendar.zone->is_turned() || offsets.size() > 1) return name;
  return name + ", " + io::offset_text(std::llround(offsets.front().ahead_s));
}

}  // namespace

std::vector<Tick> calendar_ticks(const Range& range, std::size_t most,
                                 const io::Calendar& calendar) {
  const auto offsets = clock_offsets(calendar, {range.low, range.high});
  const double step_s = clock_step(range.size(), most);
  const double midnight_s = std::floor((range.low + offsets.front().ahead_s) / kADay_s) * kADay_s;
  std::vector<Tick> ticks;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const bool is_last = i + 1 == offsets.size();
    const double ends_s = is_last ? range.high : offsets[i + 1].from_s;
    const double shift_s = offsets[i].ahead_s - midnight_s;
    for (const double since_s :
         multiples({offsets[i].from_s + shift_s, ends_s + shift_s}, step_s)) {
      const double time_s = since_s - shift_s;
      // Then the clock is turned, and shows another time.
      if (!is_last && time_s >= ends_s) continue;
      ticks.push_back({time_s, label_of(since_s, midnight_s, step_s, has_days(calendar))});
    }
  }
  return ticks;
}

std::string calendar_title(const Range& range, const io::Calendar& calendar) {
  std::string title = "Time (" + zone_words(range, calendar);
  if (has_days(calendar)) title += ", from " + date_label(calendar.shown_s(range.low));
  return title + ")";
}

}  // namespace beespace::report
