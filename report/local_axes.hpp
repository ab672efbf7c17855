// East, north and up at a place on the Earth.
#pragma once

#include <beespace/geodesy.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>

namespace beespace::report {

// Axes at a place, in ECEF; all of length 1 and at right angles. At the poles and in the middle of
// the Earth, where east is anywhere, they are those of longitude 0.
struct LocalAxes {
  Point east;
  Point north;
  Point up;
};
LocalAxes local_axes_at(const Point& ecef);

// The velocity, in the ECEF frame, of a bee at `ecef`, as seen from there; the inverse of
// to_ecef_velocity.
LocalVelocity to_local_velocity(const Point& ecef, const Velocity& velocity);

// Where that is, for reading: to a tenth of a millimetre from 10 km below the ground to 1,000 km
// above. Deep inside the Earth, which the middle of two may be, only roughly, but always a
// longitude and a latitude.
GeographicPosition to_geographic(const Point& ecef);

}  // namespace beespace::report
