/// @file
/// @brief The value of an option that has no default.
#pragma once

#include <limits>

namespace beespace {

/// @brief Stands for a threshold that is not given.
///
/// Only the caller knows how close is too close: a threshold must be given, and a search without
/// one returns ErrorCode::kInvalidThreshold. It is not a number (NaN), so no comparison takes it
/// for one.
inline constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

}  // namespace beespace
