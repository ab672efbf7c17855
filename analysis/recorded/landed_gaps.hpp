// Of gaps between two fixes of a drone: where it is not heard of, or where it has landed and says
// so, in records that are left out.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/find_conflicts.hpp>

#include <vector>

namespace beespace::analysis {

// Of `gaps`, which are in ascending order of (track, begins_s), what remains where bees that have
// landed are known; and where, before their first fix or after their last one, there is nothing of
// them for longer than `max_gap_s` between two times at which they stand. In the same order.
std::vector<Gap> unknown_gaps(const io::Recording& recording, const std::vector<Gap>& gaps,
                              double max_gap_s);

// Whether both stand on the ground as long as the conflict lasts: then it is none.
bool stand_throughout(const io::Recording& recording, const Conflict& conflict);

// Whether it is known that this bee stands on the ground then: within `max_gap_s` of its own
// records.
bool has_landed(const io::Recording& recording, PointId track, double time_s, double max_gap_s);

}  // namespace beespace::analysis
