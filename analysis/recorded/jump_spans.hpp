// When bees that jump do so (see io/recording/jumps.hpp): from the fix before to the one behind it
// is not known where such a bee is, as one of the two places, or times, is wrong. Where it jumps
// back to where it can have got meanwhile, the places between are the wrong ones: it is not known
// until then; in recordings that are read as a whole short stretches of these are gone (see
// io/recording/jumped_stretches.hpp).
#pragma once

#include "analysis/recorded/gaps.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>

#include <vector>

namespace beespace::analysis {

// In ascending order of (track, begins_s).
std::vector<Gap> jump_spans(const io::Recording& recording);

// Leaves out conflicts that begin and end while one of the two jumps from one fix to the next: it
// is not there, and it is said that it is not known where it is.
void leave_out_jumps(const io::Recording& recording, std::vector<Conflict>& conflicts);

// When bees have records without a place, two in a row or more: from the fix before to the one
// behind; and their own gaps (see own_gaps.hpp). Who says with --max-gap how far fixes may be apart
// means these, too.
std::vector<Gap> lost_spans(const io::Recording& recording, const MaxGap& max_gap);

// Both: when a bee is not known where it has fixes, beside its gaps.
std::vector<Gap> doubtful_spans(const io::Recording& recording, const MaxGap& max_gap);

// Whether that is in one of them, and not at its end; `spans` are in that order.
bool is_within(const std::vector<Gap>& spans, PointId track, double time_s);

// Both, each once, in that order.
std::vector<Gap> joined_gaps(std::vector<Gap> some, const std::vector<Gap>& more);

}  // namespace beespace::analysis
