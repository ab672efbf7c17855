/// @file
/// @brief What agents that report at times of their own have done. Part of <beespace.h>.
#ifndef BEESPACE_C_RECORDING_H
#define BEESPACE_C_RECORDING_H

#include <beespace/c/basics.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief What is known of agents besides their positions: which one, and when. Nothing is copied;
/// strides are as of beespace_points.
typedef struct beespace_fixes {
  size_t struct_size;       ///< sizeof(beespace_fixes)
  int64_t reserved;         ///< Zero.
  const int64_t* agents;    ///< The agent of each fix: any number is an id.
  const double* times_s;    ///< The time of each fix, in seconds from any moment.
  ptrdiff_t agents_stride;  ///< Bytes from one agent to the next.
  ptrdiff_t times_stride;   ///< Bytes from one time to the next.
  /// @brief The height of each fix, kept apart from its position, which is then horizontal: for a
  /// vertical threshold between agents whose third axis is not the height. In metres or in
  /// `height_unit_m`. Or NULL.
  const double* heights_m;
  /// @brief Of reports to a live swarm, with heights: the climb rate of each, in the unit of
  /// heights per second; NULL where all fly level. Else NULL.
  const double* climbs_mps;
  ptrdiff_t heights_stride;  ///< Bytes from one height to the next.
  ptrdiff_t climbs_stride;   ///< Bytes from one climb rate to the next.
  double height_unit_m;  ///< Of a recording: the length in metres of one unit of heights; 0 is 1.
} beespace_fixes;

/// @brief Where agents were and when, in memory of its own. Many threads may ask at the same time.
typedef struct beespace_recording beespace_recording;

/// @brief Makes a recording of fixes, which may be of many agents in any order; the times of each
/// agent ascend.
///
/// Between two of its fixes an agent moves in the straight line through both, at constant velocity;
/// before the first and behind the last it is absent. 32 bytes and some hundred nanoseconds a fix.
///
/// @param fixes The agent and the time of each fix; copied.
/// @param positions The position of each fix, in metres; copied. How many there are says how many
///   fixes there are. In the motion domain, as beespace_closest_approach() says.
/// @param run What ends the call early; or NULL.
/// @param[out] recording The recording, to be freed by beespace_recording_free(); NULL after an
///   error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error:
///   - BEESPACE_TIME_ORDER: a time that does not come after the one before it of the same agent,
///     also where it is the same; with the fix in beespace_error::record;
///   - BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN: a time, a coordinate or a height; likewise;
///   - BEESPACE_INVALID_ARGUMENT, BEESPACE_STOPPED, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_recording_create(const beespace_fixes* fixes,
                                                       const beespace_points* positions,
                                                       const beespace_run* run,
                                                       beespace_recording** recording,
                                                       beespace_error* error);
/// @brief Frees a recording; no call may be using it.
/// @param recording The recording; NULL does nothing.
BEESPACE_C_API void beespace_recording_free(beespace_recording* recording);
/// @brief Says how many agents have a fix.
/// @param recording The recording.
/// @return The number of agents; 0 of NULL.
BEESPACE_C_API int64_t beespace_recording_agents(const beespace_recording* recording);

/// @brief Which agents came closer than the threshold to each other, when, and how close?
///
/// A pass between two fixes is found as well. Whether two are in conflict at some instant is
/// decided as real numbers; times and distances are doubles for reading.
///
/// @param recording The recording.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL, BEESPACE_MAX_RESULTS.
///   A recording with heights apart must be asked with a vertical threshold, in their unit.
/// @param max_gap_s The longest time in seconds between two fixes of an agent that is bridged by a
///   straight line; above zero, INFINITY for all. Where fixes are farther apart, it is unknown
///   where the agent is: it is compared with none, and the gap is in the result.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result first and second are the ids of agents, in ascending order, first < second;
///   a pair may be in conflict several times. When each conflict begins, is closest and ends, and
///   how close it is. And the gaps: without conflicts, agents kept their distance but for what may
///   have been in these.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_INVALID_THRESHOLD,
///   BEESPACE_INVALID_ARGUMENT, BEESPACE_TOO_MANY_RESULTS, BEESPACE_TOO_MANY_POINTS,
///   BEESPACE_STOPPED, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_recording_conflicts(const beespace_recording* recording,
                                                          const beespace_search* search,
                                                          double max_gap_s, const beespace_run* run,
                                                          beespace_result* result,
                                                          beespace_error* error);

/// @brief Which two agents came closest to each other, when, and how close?
/// @param recording The recording; one with heights apart has no answer.
/// @param max_gap_s As of beespace_recording_conflicts().
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result One pair, all three of whose times are the closest instant; none where no two
///   are known to be there at the same time. And the gaps.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_recording_conflicts(), but for the
///   threshold and the number of results.
BEESPACE_C_API beespace_code beespace_recording_closest(const beespace_recording* recording,
                                                        double max_gap_s, const beespace_run* run,
                                                        beespace_result* result,
                                                        beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
