// How fast a bee climbs at its last fix, where that fix does not say so.
#pragma once

#include "io/recording/recording.hpp"

#include <cstdint>
#include <optional>

namespace beespace::analysis {

// Whether heights go in steps, as those of transponders, of 25 ft: of two fixes a second apart
// these make a climb of 1500 ft/min, or none, whatever the true one is.
bool heights_in_steps(const io::Recording& recording, const io::RecordedBee& bee);

// What a climb rate is taken from.
enum class ClimbFrom : std::uint8_t {
  kRecord,    // the last fix says it
  kEarlier,   // the last fix that says it
  kHeights,   // those of the last seconds
  kTwoFixes,  // the last two, where heights do not go in steps
};

struct LastClimb {
  double up_mps = 0.0;
  ClimbFrom from = ClimbFrom::kRecord;
};

// An earlier fix says it for so long; heights in steps tell it over a time that is neither shorter,
// as steps then weigh too much, nor longer, as the bee may have levelled off since.
inline constexpr double kClimbLasts_s = 30.0;
inline constexpr double kShortestClimb_s = 10.0;
inline constexpr double kLongestClimb_s = 20.0;

// Of a bee with fixes whose heights go in steps. The rate that was told less than kShortestClimb_s
// ago, or else the slope of the heights of the last kLongestClimb_s, or of the last two fixes where
// these are farther apart, but max_age_s at most; or else the rate that was told kClimbLasts_s ago
// at most. Nothing where there is none of them: then the bee must not be taken as level.
std::optional<LastClimb> last_climb(const io::RecordedBee& bee, double max_age_s);

}  // namespace beespace::analysis
