/// @file
/// @brief When are two movers closest, and which of many come too close? Part of <beespace.h>.
#ifndef BEESPACE_C_MOTION_H
#define BEESPACE_C_MOTION_H

#include <beespace/c/search.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief When are two movers closest, how close, and when closer than the threshold? Of many twos:
/// each mover and the other mover of the same index.
///
/// Each moves on in a straight line at constant velocity, from 0 s to the horizon. Whether two are
/// in conflict is decided as real numbers on the given values; times and distances are doubles for
/// reading. Some hundred nanoseconds a two, on one thread.
///
/// Positions, velocities, thresholds and the horizon are 0 or of magnitudes up to 2^100 (about
/// 1.3e+30); what is smaller than 2^-100 counts as 0.
///
/// @param positions Where the movers are, in metres.
/// @param velocities Their velocities, in metres per second; as many as positions.
/// @param other_positions Where the other movers are; as many. Strides of 0 repeat one.
/// @param other_velocities Their velocities.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL. Or NULL: only when
///   they are closest and how close.
/// @param horizon_s How far to look ahead, in seconds; zero or more.
/// @param run What ends the call early; or NULL.
/// @param[out] result For each two when they are closest (of several such instants the first) and
///   their straight-line distance then; with a threshold, when their conflict begins and ends
///   within the horizon, NaN where there is none.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error:
///   - BEESPACE_INVALID_THRESHOLD: of `threshold_m` or `vertical_m`;
///   - BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN: a coordinate; beespace_error::place says of
///     which of the four arguments, beespace_error::record which one;
///   - BEESPACE_INVALID_ARGUMENT: a horizon that makes no sense, arrays that differ in number;
///   - BEESPACE_STOPPED, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_closest_approach(
    const beespace_points* positions, const beespace_points* velocities,
    const beespace_points* other_positions, const beespace_points* other_velocities,
    const beespace_search* search, double horizon_s, const beespace_run* run,
    beespace_result* result, beespace_error* error);

/// @brief Which movers come closer than the threshold to each other within the horizon, and when?
///
/// All move on in straight lines at constant velocity. No pair is missed, however fast. Time grows
/// with the number of movers and of pairs that may pass each other.
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param positions Where the movers are, in metres.
/// @param velocities Their velocities, in metres per second; as many as positions.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL, BEESPACE_MAX_RESULTS.
/// @param horizon_s How far to look ahead, in seconds; zero or more.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result first and second in ascending order, each pair once; when they come closer
///   than the threshold (0 where they are), when they are closest and how close, when they are
///   apart again (the horizon where they are not).
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_closest_approach(), and
///   BEESPACE_TOO_MANY_POINTS, BEESPACE_TOO_MANY_RESULTS.
BEESPACE_C_API beespace_code beespace_predict(beespace_engine* engine,
                                              const beespace_points* positions,
                                              const beespace_points* velocities,
                                              const beespace_search* search, double horizon_s,
                                              const beespace_run* run, beespace_result* result,
                                              beespace_error* error);

/// @brief Which movers come closer than the threshold to each other within the horizon?
///
/// As beespace_predict(), without when and how close: over a short time little more than
/// beespace_pairs().
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param positions As of beespace_predict().
/// @param velocities As of beespace_predict().
/// @param search As of beespace_predict().
/// @param horizon_s As of beespace_predict().
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result first and second in ascending order, each pair once.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_predict().
BEESPACE_C_API beespace_code beespace_predict_pairs(beespace_engine* engine,
                                                    const beespace_points* positions,
                                                    const beespace_points* velocities,
                                                    const beespace_search* search, double horizon_s,
                                                    const beespace_run* run,
                                                    beespace_result* result, beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
