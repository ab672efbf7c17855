// When a plan whose times count from its beginning was begun, by the clock of what was flown: a
// proposal, for people to confirm, by the take-off.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::analysis {

// Fixes of one bee, whose z are heights, as they were set and flown.
struct SetAndFlownFixes {
  std::vector<Fix> set;
  std::vector<Fix> flown;
};

struct TakeOffOffset {
  double seconds = 0.0;  // what is set at 0 was flown so late by the clock of what was flown
  std::size_t bees = 0;  // whose take-offs say so
};

// Take-off is when a bee is first this much higher than at its first fix: more than the heights of
// satellite fixes waver on the ground.
inline constexpr double kTakenOff_m = 2.0;

// The middle of what the bees say. Nothing where none takes off in both, or where they do not
// agree: where the middle half of them is spread over more than a second.
std::optional<TakeOffOffset> take_off_offset(const std::vector<SetAndFlownFixes>& bees);

}  // namespace beespace::analysis
