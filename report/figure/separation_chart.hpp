// How far apart the closest two of a recording are, over time.
#pragma once

#include "report/facts.hpp"
#include "report/figure/panel.hpp"

#include <vector>

namespace beespace::report {

// When any bee is in conflict, stretches that touch put together; ascending.
std::vector<TimeSpan> times_in_conflict(const std::vector<AtRisk>& at_risk);

void draw_separation(const RecordingFacts& facts, const Box& box, Drawing& drawing);

// "63.2 s", or the time of day where that is known, in the zone in which times are told; of a
// recording of more than a day with month and day before it, "05-24 07:01:57".
std::string moment_label(double time_s, const RecordingFacts& facts);

}  // namespace beespace::report
