// Aircraft that stand still by their own reports, as on an apron, without saying that they are on
// the ground: for a minute or longer they tell no speed, and one place and height.
//
// A helicopter that hovers says the same. So what stands still is compared with all others, and
// its conflicts are told, behind those of two that fly.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/track.hpp>

#include <vector>

namespace beespace::analysis {

// When it stands so, in ascending order.
std::vector<TimeSpan> still_times(const io::RecordedBee& bee, io::Frame frame);

// Of these, in a recording of aircraft, those in which one of the two stands still as long as they
// last.
std::vector<Conflict> beside_still(const io::Recording& recording,
                                   const std::vector<Conflict>& conflicts);

}  // namespace beespace::analysis
