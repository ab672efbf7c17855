#include "report/clock_offsets.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::report {
namespace {

constexpr double kLooked_s = 86'400.0;  // no clocks are turned twice within a day
constexpr double kMostLooks = 20'000.0;
// Beyond some thousands of years from 1970 there are no dates.
constexpr double kFarthestDate_s = 1e11;

// The second from which on the clock is ahead as it is at `to_s`, where it is not yet at `from_s`.
double turned_at(const io::Calendar& calendar, double from_s, double to_s) {
  const double ahead_s = calendar.shown_s(to_s) - to_s;
  while (to_s - from_s > 1.0) {
    const double middle_s = std::floor(0.5 * (from_s + to_s));
    if (!(middle_s > from_s)) break;
    (calendar.shown_s(middle_s) - middle_s == ahead_s ? to_s : from_s) = middle_s;
  }
  return to_s;
}

}  // namespace

std::vector<ClockOffset> clock_offsets(const io::Calendar& calendar, const TimeSpan& time) {
  std::vector<ClockOffset> offsets = {
      {time.begins_s, std::round(calendar.shown_s(time.begins_s) - time.begins_s)}};
  if (!calendar.is_local()) return offsets;
  const double begins_s = std::clamp(time.begins_s, -kFarthestDate_s, kFarthestDate_s);
  const double ends_s = std::clamp(time.ends_s, -kFarthestDate_s, kFarthestDate_s);
  const double step_s = std::max(kLooked_s, (ends_s - begins_s) / kMostLooks);
  double from_s = std::floor(begins_s);
  while (from_s < ends_s) {
    const double to_s = std::min(std::ceil(from_s + step_s), std::ceil(ends_s));
    const double ahead_s = std::round(calendar.shown_s(to_s) - to_s);
    if (ahead_s != offsets.back().ahead_s) {
      const double at_s = turned_at(calendar, from_s, to_s);
      if (at_s <= ends_s) offsets.push_back({at_s, ahead_s});
    }
    from_s = to_s;
  }
  return offsets;
}

}  // namespace beespace::report
