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

std::string moment_text(double time_s, const io::Recording& recording) {
  // Within a few thousand years; and not what is no time at all.
  constexpr double kFarthest_s = 1e11;
  if (recording.since_1970 && std::abs(time_s) < kFarthest_s) return date_and_time(time_s);
  return io::grouped(time_s, 2) + " s";
}

}  // namespace beespace::analysis
