// East, north and up at a place on the Earth.
#pragma once

#include <beespace/geodesy.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>

namespace beespace::cli {

// The velocity, in the ECEF frame, of a bee at `ecef`, as seen from there; the inverse of
// to_ecef_velocity. At the poles and in the middle of the Earth, where east is anywhere, it is that
// of longitude 0.
LocalVelocity to_local_velocity(const Point& ecef, const Velocity& velocity);

}  // namespace beespace::cli
