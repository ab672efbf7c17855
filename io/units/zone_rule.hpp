// How clocks are turned every year, as POSIX writes it in TZ: "CET-1CEST,M3.5.0,M10.5.0/3".
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace beespace::io {

// A day of every year, and a time on it.
struct YearlyDay {
  enum class Kind : std::uint8_t {
    kDayOfYear,       // 0 to 365, the 29th of February counted
    kDayOfPlainYear,  // 1 to 365, it is never counted
    kWeekday,         // of the `week`th time in the month, 5 is the last
  };

  Kind kind = Kind::kWeekday;
  int day = 0;  // of the year, or of the week, from Sunday
  int month = 0;
  int week = 0;
  std::int64_t time_s = 7200;  // since midnight on clocks until then; it may be on other days

  // Since 1970-01-01 00:00:00 on these clocks.
  [[nodiscard]] std::int64_t in_year(int year) const;
};

struct ZoneRule {
  struct Summer {
    std::int64_t offset_s = 0;
    YearlyDay begins = {};
    YearlyDay ends = {};
  };

  std::int64_t offset_s = 0;  // ahead of UTC
  std::optional<Summer> summer = {};
};

// Nothing where it is no such rule.
std::optional<ZoneRule> parse_zone_rule(std::string_view text);

}  // namespace beespace::io
