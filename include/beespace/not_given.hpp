// What an option holds that has no default.
#pragma once

#include <limits>

namespace beespace {

// How close is too close is nobody's to guess: a threshold must be given, and a search without one
// answers kInvalidThreshold. Not a number, so no comparison takes it for one.
inline constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

}  // namespace beespace
