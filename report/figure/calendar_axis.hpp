// An axis of time that shows what clocks show.
#pragma once

#include "report/facts.hpp"
#include "report/figure/scale.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace beespace::report {

// At whole hours, days, ... of the clock, also where it is turned in between; as tables tell them:
// month and day where a day begins, otherwise the time of day.
std::vector<Tick> calendar_ticks(const Range& range, std::size_t most,
                                 const io::Calendar& calendar);

// "Time (UTC, from 2024-05-01)", "Time (Europe/Madrid, +02:00, from 2024-05-01)", "Time (as in the
// file, from 2024-05-01)".
std::string calendar_title(const Range& range, const io::Calendar& calendar);

}  // namespace beespace::report
