// Two bees while each is on one straight piece of its track: the exact decision, and the numbers of
// the report.
#pragma once

#include "motion/relative_motion.hpp"
#include "motion/separation.hpp"
#include "motion/track_segments.hpp"

namespace beespace::motion {

// Whether they are in conflict at some instant of the window, during which both are on their piece:
// exact, for the rational lines through the fixes.
bool in_conflict(const Piece& first, const Piece& second, const TimeSpan& window,
                 const Separation& separation);

// The second relative to the first, from `time_s` on.
RelativeMotion<4> relative_motion(const Piece& first, const Piece& second, double time_s);

}  // namespace beespace::motion
