// Values that are too small for exact comparison become zero at the input: those of a magnitude
// below kSmallestInMotion, 2^-100 (see mover.hpp). NaN and values that are too large stay as they
// are, for the checks of validate.hpp.
//
// The effect is bounded. A coordinate moves by less than 2^-100 m, so a position, the root of three
// squares, by less than 2^-99 m; a velocity by less than 2^-99 m/s. A bee that flies on for T
// seconds is then off by less than (1 + T) 2^-99 m, and the distance of two by less than (1 + T)
// 2^-98 m (two differences, each below that of one bee): with T up to 10^9 s less than 3.2e-21 m,
// which is less than half a unit in the last place of any coordinate from 1e-4 m on. Heights and
// climb rates that are kept apart change by less than 2^-100 each, and height differences by less
// than (1 + T) 2^-99 m. A time moves by less than 2^-100 s: at each instant the bee is where it
// would have been within 2^-100 s of it. An answer is that of the exact question about the flushed
// values; so it can differ from that about the given ones only for pairs whose distance is within
// these bounds of the threshold.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <cmath>

namespace beespace::motion {

inline bool too_small(double value) {
  return value != 0.0 && std::abs(value) < kSmallestInMotion;
}

inline double flushed(double value) {
  return std::abs(value) < kSmallestInMotion ? 0.0 : value;
}
inline Point flushed(const Point& p) {
  return {flushed(p.x), flushed(p.y), flushed(p.z)};
}
inline Velocity flushed(const Velocity& v) {
  return {flushed(v.x), flushed(v.y), flushed(v.z)};
}
inline Mover flushed(const Mover& mover) {
  return {flushed(mover.position), flushed(mover.velocity)};
}
inline Fix flushed(const Fix& fix) {
  return {flushed(fix.time_s), flushed(fix.position)};
}

}  // namespace beespace::motion
