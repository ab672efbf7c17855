// Two bees that come too close to each other: between whom, from when to when, and how close.
//
// Units: metres and seconds. Which pairs are in conflict is decided with real numbers on the given
// doubles; the times and distances of a conflict are doubles for reading, computed by one function
// that rounds alike everywhere.
#pragma once

#include <beespace/point.hpp>

namespace beespace {

struct TimeSpan {
  double begins_s = 0.0;
  double ends_s = 0.0;

  friend constexpr bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

struct Conflict {
  PointId first = 0;  // below second
  PointId second = 0;
  double begins_s = 0.0;   // when they come closer than the threshold, or where we begin to look
  double closest_s = 0.0;  // when they are closest in all that time
  double ends_s = 0.0;     // when they are apart again, or where we stop looking
  double closest_m = 0.0;  // how far apart they are then, in a straight line

  // False where the paths are known with some tolerance only (Track::tolerance_m), and the two may
  // have kept apart.
  bool certain = true;

  friend constexpr bool operator==(const Conflict&, const Conflict&) = default;
};

}  // namespace beespace
