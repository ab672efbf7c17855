/// @file
/// @brief From geographic positions to Cartesian coordinates in metres.
///
/// Input: WGS84 longitude and latitude in degrees, height above the ellipsoid in metres.
/// Output: Earth-centred, Earth-fixed (ECEF) coordinates in metres; x towards 0 N 0 E, y towards
/// 0 N 90 E, z towards the north pole.
///
/// The conversion uses only + - * / and square root on doubles, so every machine returns the same
/// bits; it differs from exact arithmetic by less than 1e-8 m up to a height of 1,000 km.
///
/// Thread safety: no state is kept. Source: Heiskanen and Moritz, Physical Geodesy, 1967, 5-3.
#pragma once

#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <span>

namespace beespace {

/// @brief A position on or above the Earth.
struct GeographicPosition {
  double longitude_deg = 0.0;  ///< Degrees, -360 to 360, east positive.
  double latitude_deg = 0.0;   ///< Degrees, -90 to 90, north positive.
  double height_m = 0.0;       ///< Metres above the WGS84 ellipsoid.
};

/// @brief The lowest height in metres that is accepted. Heights beyond the two limits are taken for
/// a mistake (feet, millimetres, swapped columns).
inline constexpr double kLowestHeight_m = -12'000.0;
/// @brief The greatest height in metres that is accepted.
inline constexpr double kGreatestHeight_m = 1'000'000.0;

/// @brief Converts one position.
/// @param position The geographic position, in degrees and metres.
/// @return The ECEF position in metres; or an error:
///   - ErrorCode::kNotFinite: a NaN or an infinity;
///   - ErrorCode::kInvalidLatitude, ErrorCode::kInvalidLongitude: beyond +-90 and +-360 degrees;
///   - ErrorCode::kInvalidHeight: a height beyond #kLowestHeight_m or #kGreatestHeight_m.
BEESPACE_API Result<Point> to_ecef(const GeographicPosition& position);

/// @brief Converts many positions at once.
///
/// Complexity: some nanoseconds a point.
///
/// @param positions Point i has x = longitude and y = latitude in degrees, z = height in metres.
/// @param[out] ecef Entry i is the ECEF position of point i, in metres. It may be the memory of
///   `positions` (in place). After an error its contents are unspecified.
/// @return Success; or an error as that of one position, with the index of the first bad position
/// in
///   ErrorLocation::record, or ErrorCode::kInvalidArgument when the sizes differ.
BEESPACE_API Status to_ecef(const PointsView& positions, std::span<Point> ecef);

/// @brief A velocity along the parallel, the meridian and the normal of the ellipsoid.
struct LocalVelocity {
  double east_mps = 0.0;   ///< Metres per second towards the east.
  double north_mps = 0.0;  ///< Metres per second towards the north.
  double up_mps = 0.0;     ///< Metres per second upwards.
};

/// @brief Makes a local velocity of a speed and a track over ground, as aircraft report them.
/// @param ground_speed_mps The speed over ground in metres per second.
/// @param track_deg The track over ground in degrees clockwise from true north; any finite number
/// of
///   turns up to 10^12.
/// @param climb_mps The rate of climb in metres per second.
/// @return The velocity.
BEESPACE_API LocalVelocity local_velocity(double ground_speed_mps, double track_deg,
                                          double climb_mps);

/// @brief Converts a local velocity to the ECEF frame.
/// @param position Where the agent is, in degrees and metres.
/// @param velocity Its local velocity, in metres per second.
/// @return The velocity in the ECEF frame, in metres per second; or an error as to_ecef, and
///   ErrorCode::kNotFinite for a velocity that is not finite.
BEESPACE_API Result<Velocity> to_ecef_velocity(const GeographicPosition& position,
                                               const LocalVelocity& velocity);

}  // namespace beespace
