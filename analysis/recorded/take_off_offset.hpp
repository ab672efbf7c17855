// When a plan whose times count from its beginning was begun, by the clock of what was flown: a
// proposal, for people to confirm, by the take-offs.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace beespace::analysis {

// Fixes of one bee, whose z are heights, as they were set and flown.
struct SetAndFlownFixes {
  std::span<const Fix> set;
  std::span<const Fix> flown;
  bool from_ground = true;  // what was flown begins there: otherwise a climb is no take-off
};

struct TakeOffOffset {
  double seconds = 0.0;  // what is set at 0 was flown so late by the clock of what was flown
  std::size_t bees = 0;  // whose take-offs say so
};

// Take-off is when a bee is first this much higher than at its first fix, or than where it has
// landed meanwhile: more than the heights of satellite fixes waver on the ground.
inline constexpr double kTakenOff_m = 2.0;

// When it takes off for the first time; nothing where it does not.
std::optional<double> first_take_off_s(std::span<const Fix> fixes);

// Of each flight the middle of what the bees say, in ascending order: a recording of a rehearsal
// and of the show has two. Only what more than half of all bees say, within a second of each other;
// take-offs within what was set are no further flights.
std::vector<TakeOffOffset> take_off_offsets(const std::vector<SetAndFlownFixes>& bees);

}  // namespace beespace::analysis
