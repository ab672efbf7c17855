// Times of a recording as pictures, pages and tables tell them: in UTC, in the zone that was named,
// or as they stand in the file, where it names none.
#pragma once

#include "io/recording/moment_text.hpp"

#include <string>

namespace beespace::report {

// "2024-05-01T12:03:30.25Z", "2024-05-01T14:03:30.25+02:00"; of a clock whose zone is not known
// "2024-05-01 12:03:30.25", or "12:03:30.25". Nothing where times are seconds, or beyond all dates.
std::string date_time_label(double time_s, const io::Calendar& calendar);

// To the nearest second, without what all times of a recording have in common: "12:03:30", or with
// the offset of a zone that was named "14:03:30+02:00"; with month and day, where the days are
// known, "05-24 07:01:57". Nothing as above.
std::string short_moment_label(double time_s, const io::Calendar& calendar, bool with_day);

}  // namespace beespace::report
