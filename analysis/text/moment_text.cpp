#include "analysis/text/moment_text.hpp"

#include "io/bytes/number_text.hpp"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace beespace::analysis {
namespace {

std::string date_and_time(double since_1970_s) {
  using std::chrono::floor;
  // Rounded first, so that 59.9996 s become the next minute.
  const double rounded_s = std::round(since_1970_s * 1e3) / 1e3;
  const double whole = std::floor(rounded_s);
  const std::chrono::sys_seconds seconds{std::chrono::seconds(static_cast<std::int64_t>(whole))};
  const auto day = floor<std::chrono::days>(seconds);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss time{seconds - day};
  char text[40];
  std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%06.3fZ", int{date.year()},
                unsigned{date.month()}, unsigned{date.day()},
                static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
                static_cast<double>(time.seconds().count()) + (rounded_s - whole));
  return text;
}

}  // namespace

std::string utc_text(double since_1970_s) {
  constexpr double kFarthest_s = 1e11;
  return std::abs(since_1970_s) < kFarthest_s ? date_and_time(since_1970_s) : std::string();
}

std::string moment_text(double time_s, const io::Recording& recording) {
  const std::string date = recording.since_1970 ? utc_text(time_s) : std::string();
  return date.empty() ? io::grouped(time_s, 2) + " s" : date;
}

}  // namespace beespace::analysis
