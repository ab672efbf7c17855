// What can be a command, and a branch: the rest is refused before any of it is used.
#pragma once

#include "fleet/nominal_path.hpp"

#include <beespace/advise.hpp>
#include <beespace/command.hpp>
#include <beespace/result.hpp>

#include <optional>

namespace beespace::fleet {

// Ticks beyond this are refused or cut, so that sums of a few of them do not overflow.
inline constexpr Tick kLargestTick = Tick{1} << 62U;

// Whether the limits and the period make sense, and braking ends.
std::optional<Error> check_planned(const FlightLimits& planned, double period_s);

// Whether two states are the same but for what the rounding of a message may change.
bool nearly_same(const Mover& a, const Mover& b);

// Whether it can be a branch: its numbers and counts, and a path that the limits allow. Nothing
// else may be asked of a command for which this is false.
bool can_be(const Command& command, const FlightLimits& planned, const Braking& braking);

}  // namespace beespace::fleet
