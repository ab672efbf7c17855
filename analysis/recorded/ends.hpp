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

// Nothing for a bee without fixes.
std::optional<Ends> ends_of(const io::RecordedBee& bee);

// A drone of a show that begins or ends as close to the ground as this stands there before or
// after.
inline constexpr double kStandsWithin_m = 0.1;

// The height of the ground: where a show says it is, or the lowest place at which a bee begins or
// ends. Shows count heights from the ground: one of which all is higher than 1 m is no whole show,
// and its ground is at 0.
double ground_of(const io::Recording& recording);

}  // namespace beespace::analysis
