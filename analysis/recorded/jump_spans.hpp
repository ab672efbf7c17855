// When bees that jump do so (see io/recording/jumps.hpp): from the fix before to the one behind it
// is not known where such a bee is, as one of the two places, or times, is wrong.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/find_conflicts.hpp>

#include <vector>

namespace beespace::analysis {

// In ascending order of (track, begins_s).
std::vector<Gap> jump_spans(const io::Recording& recording);

// Whether that is in one of them, and not at its end; `spans` are in that order.
bool is_within(const std::vector<Gap>& spans, PointId track, double time_s);

// Both, each once, in that order.
std::vector<Gap> joined_gaps(std::vector<Gap> some, const std::vector<Gap>& more);

}  // namespace beespace::analysis
