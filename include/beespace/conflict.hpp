/// @file
/// @brief A conflict: which two agents come closer than the threshold, from when to when, and how
/// close.
///
/// Units: metres and seconds. Which pairs are in conflict is decided with real numbers on the given
/// doubles; the times and distances of a conflict are doubles for reading, computed by one function
/// that rounds alike on every machine.
#pragma once

#include <beespace/point.hpp>

namespace beespace {

/// @brief A closed interval of time.
struct TimeSpan {
  double begins_s = 0.0;  ///< Its first instant, in seconds.
  double ends_s = 0.0;    ///< Its last instant, in seconds.

  friend constexpr bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

/// @brief Two agents that are closer than the threshold for some time.
struct Conflict {
  PointId first = 0;       ///< One agent; below `second`.
  PointId second = 0;      ///< The other agent.
  double begins_s = 0.0;   ///< When they come closer than the threshold, or when the search begins.
  double closest_s = 0.0;  ///< When they are closest in all that time.
  double ends_s = 0.0;     ///< When they are apart again, or when the search ends.
  double closest_m = 0.0;  ///< Their straight-line distance at `closest_s`, in metres.

  /// @brief False where the paths are known with some tolerance only (Track::tolerance_m), and the
  /// two may have kept apart.
  bool certain = true;

  friend constexpr bool operator==(const Conflict&, const Conflict&) = default;
};

}  // namespace beespace
