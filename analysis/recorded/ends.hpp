// Where bees begin and end, and where the ground is.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/track.hpp>

#include <optional>

namespace beespace::analysis {

// Where and when a bee is first and last, and the fixes beside these: the same ones of a bee that
// has no more, and of a curve.
struct Ends {
  Fix first;
  Fix second;
  Fix last_but_one;
  Fix last;
};

// Nothing for a bee without fixes, as a drone that never takes off.
std::optional<Ends> ends_of(const io::RecordedBee& bee);

// A drone of a show that begins or ends as close to the ground as this stands there before or
// after.
inline constexpr double kStandsWithin_m = 0.1;

// The height of the ground: where a show says it is, or the lowest place at which a bee begins or
// ends; 0 of a show of which all is higher than io::kHighestShowGround_m and that does not say so.
double ground_of(const io::Recording& recording);

}  // namespace beespace::analysis
