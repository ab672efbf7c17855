// Whether a bee in degrees gets from one fix to the next otherwise than its own velocities there
// say: by much more than lags, rounding and steps of heights explain. One of the two places is
// wrong then, or its time is, as where a receiver took one message for another one.
//
// A velocity that is stated may be kRatesLag_s old, and in between the bee may have flown level, or
// as at either end. Heights go in steps of 100 ft at most, and climb rates change by
// kClimbsDiffer_mps without a word about it. Of fixes farther apart than kFarApart_s velocities say
// little.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/track.hpp>

namespace beespace::io {

// `from` is the earlier one. Of velocities not-a-numbers are not known; null: none is.
bool contradicts_stated_climb(const Fix& from, const Velocity* from_velocity, const Fix& to,
                              const Velocity* to_velocity);
bool contradicts_stated_speed(const Fix& from, const Velocity* from_velocity, const Fix& to,
                              const Velocity* to_velocity);

}  // namespace beespace::io
