// When something is, as text.
#pragma once

#include "io/recording/recording.hpp"

#include <optional>
#include <string>

namespace beespace::io {

// "2024-05-01T12:00:00.250Z"; nothing for what is not within a few thousand years of 1970.
std::string utc_text(double since_1970_s);

// How times of a recording are told to people where they are more than seconds.
struct Calendar {
  bool since_1970 = false;
  std::optional<TimeZone> zone = {};    // of those since 1970; none: UTC
  std::optional<WallClock> clock = {};  // or they count from a midnight of a clock

  // Whether they are told as dates, or times of day.
  [[nodiscard]] bool tells() const { return since_1970 || clock; }
  // "2024-05-01T12:00:00.250Z", "2024-05-01T14:00:00.250+02:00"; of a clock whose zone is not known
  // "2024-05-01 12:00:00.250", or "12:00:00.250"; nothing where there is no such text.
  [[nodiscard]] std::string text(double time_s) const;
  // What a clock that tells a time shows, in seconds since 1970-01-01 00:00:00 on it; of one whose
  // day is not known, since its midnight.
  [[nodiscard]] double shown_s(double time_s) const;
  // Whether they are told in a zone whose clocks are not those of UTC.
  [[nodiscard]] bool is_local() const;
};

Calendar calendar_of(const Recording& recording);

// "seconds since 1970-01-01T00:00:00Z", "seconds", ...: what the numbers are.
std::string clock_text(const Recording& recording);

// "12.5 s", or the date and time where seconds count from 1970 or a midnight.
std::string moment_text(double time_s, const Recording& recording);

}  // namespace beespace::io
