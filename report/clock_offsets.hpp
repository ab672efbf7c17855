// By how much clocks are ahead of the times of a recording, from when to when: they may be turned
// while it lasts.
#pragma once

#include "io/recording/moment_text.hpp"

#include <beespace/track.hpp>

#include <vector>

namespace beespace::report {

struct ClockOffset {
  double from_s = 0.0;
  double ahead_s = 0.0;  // what the clock shows (Calendar::shown_s), less the time
};

// Ascending, the first from the beginning of the span on; at least one.
std::vector<ClockOffset> clock_offsets(const io::Calendar& calendar, const TimeSpan& time);

}  // namespace beespace::report
