/// @file
/// @brief WGS84 degrees and heights as metres. Part of <beespace.h>.
#ifndef BEESPACE_C_GEODESY_H
#define BEESPACE_C_GEODESY_H

#include <beespace/c/basics.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief Converts WGS84 positions to metres in an Earth-centred, Earth-fixed frame (ECEF).
///
/// x points towards 0 N 0 E, y towards 0 N 90 E, z towards the north pole. Every machine returns
/// the same bits, which differ from exact arithmetic by less than 1e-8 m. Some nanoseconds a point.
///
/// @param positions As x the longitudes in degrees, -360 to 360, east positive; as y the latitudes
///   in degrees, -90 to 90, north positive; as z the heights in metres above the ellipsoid, -12,000
///   to 1,000,000, which must be given.
/// @param[out] xyz The coordinates in metres, interleaved: room for 3 * count of them, which
///   beespace_points_interleaved() reads. Unspecified after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error, with its position in beespace_error::record:
///   BEESPACE_NOT_FINITE, BEESPACE_INVALID_LATITUDE, BEESPACE_INVALID_LONGITUDE,
///   BEESPACE_INVALID_HEIGHT; or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_to_ecef(const beespace_points* positions, double* xyz,
                                              beespace_error* error);

/// @brief Converts velocities along the parallel, the meridian and the normal of the ellipsoid to
/// the frame of beespace_to_ecef().
/// @param positions Where the agents are, as of beespace_to_ecef().
/// @param velocities As x towards the east, as y towards the north, as z upwards, in metres per
///   second; as many as positions. z may be NULL: none climbs.
/// @param[out] xyz The velocities in metres per second, interleaved: room for 3 * count of them.
///   Unspecified after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_to_ecef(), of positions or velocities.
BEESPACE_C_API beespace_code beespace_to_ecef_velocity(const beespace_points* positions,
                                                       const beespace_points* velocities,
                                                       double* xyz, beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
