// Gaps of who has fixes far more often than most others: an animal with a fix an hour is lost for a
// day, though the collars of the others, which have one each 12 hours, make the max gap longer.
//
// Of intervals of a minute or longer alone, which follow a schedule: what has several fixes a
// second may have them in bursts. Of aircraft receivers hear now and then.
#pragma once

#include "analysis/recorded/gaps.hpp"
#include "io/recording/recording.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/point.hpp>

#include <optional>
#include <vector>

namespace beespace::analysis {

// How far apart fixes of that bee may be, where that is less than half of the max gap; nothing
// where that was asked for.
std::optional<double> own_max_gap_s(const io::Recording& recording, PointId bee,
                                    const MaxGap& max_gap);

// In ascending order of (track, begins_s).
std::vector<Gap> own_gaps(const io::Recording& recording, const MaxGap& max_gap);

}  // namespace beespace::analysis
