// From where a bee is on the Earth to metres in space.
//
// Input: WGS84 longitude and latitude in degrees, height above the ellipsoid in metres.
// Output: Earth-centred, Earth-fixed (ECEF) coordinates in metres; x towards 0 N 0 E, y towards
// 0 N 90 E, z towards the north pole. Source: Heiskanen and Moritz, Physical Geodesy, 1967, 5-3.
//
// The conversion uses only + - * / and square root on doubles, so every machine returns the same
// bits; it differs from exact arithmetic by less than 1e-8 m up to a height of 1,000 km.
// Thread-safe; no state.
#pragma once

#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <span>

namespace beespace {

struct GeographicPosition {
  double longitude_deg = 0.0;  // -360 ... 360, east positive
  double latitude_deg = 0.0;   // -90 ... 90, north positive
  double height_m = 0.0;       // above the WGS84 ellipsoid
};

// Heights outside these are taken for a mistake (feet, millimetres, swapped columns).
inline constexpr double kLowestHeight_m = -12'000.0;
inline constexpr double kGreatestHeight_m = 1'000'000.0;

// One position. Errors: kNotFinite, kInvalidLatitude, kInvalidLongitude, kInvalidHeight.
BEESPACE_API Result<Point> to_ecef(const GeographicPosition& position);

// Many at once: point i of `positions` has x = longitude, y = latitude, z = height, and becomes
// ecef[i]. The two may be the same memory (in place). Cost: some nanoseconds a point.
// Errors: as above, with the index of the first bad position in place.record, and
// kInvalidArgument when the sizes differ; then `ecef` is left with unspecified contents.
BEESPACE_API Status to_ecef(const PointsView& positions, std::span<Point> ecef);

// Metres per second along the parallel, the meridian and the ellipsoid's normal.
struct LocalVelocity {
  double east_mps = 0.0;
  double north_mps = 0.0;
  double up_mps = 0.0;
};

// The same from a speed over ground and a track over ground, in degrees clockwise from true north
// (any finite number of turns up to 10^12), as aircraft report them.
BEESPACE_API LocalVelocity local_velocity(double ground_speed_mps, double track_deg,
                                          double climb_mps);

// The velocity in the ECEF frame of a bee at `position`. Errors: as to_ecef, and kNotFinite for a
// velocity that is not.
BEESPACE_API Result<Velocity> to_ecef_velocity(const GeographicPosition& position,
                                               const LocalVelocity& velocity);

}  // namespace beespace
