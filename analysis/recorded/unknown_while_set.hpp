// When it is not known how far a bee strays from what it was set to fly, as it is not known where
// it was: in gaps and where it is lost or jumps (see coverage.hpp), and before its first fix and
// after its last one, as far as it was set to fly then.
#pragma once

#include "analysis/recorded/gaps.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <vector>

namespace beespace::analysis {

// When bees of that recording, whose tracks these are, are there and it is not known where: in
// ascending order of (track, begins_s).
std::vector<Gap> unknown_spans_of(const io::Recording& recording, const std::vector<Track>& tracks,
                                  const MaxGap& max_gap);

// Of these those of that bee, and of the time beside its fixes: within the time in which `set` was
// set, in ascending order. Who stands where it was set to before its first fix and after its last
// one is known; so is a time that is no longer than a gap.
std::vector<TimeSpan> unknown_while_set(const Track& set, const Track& flown, PointId bee,
                                        const std::vector<Gap>& unknown, const MaxGap& max_gap);

double length_of(const std::vector<TimeSpan>& spans);

}  // namespace beespace::analysis
