/// @file
/// @brief The conflicts of recordings that are larger than memory. Part of <beespace.h>.
#ifndef BEESPACE_C_LARGE_RECORDING_H
#define BEESPACE_C_LARGE_RECORDING_H

#include <beespace/c/basics.h>
#include <beespace/c/out_of_core.h>
#include <beespace/c/recording.h>
#include <beespace/c/search.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief Where agents were and when, on the disk: it is cut in time, and searched one window of
/// time after the other. Answers are those of a beespace_recording.
typedef struct beespace_large_recording beespace_large_recording;

/// @brief Makes a recording without fixes.
/// @param options The memory and the folder, which must have room for some 60 bytes a fix, while it
///   is searched for twice as much. `height_unit_m` is that of all fixes; progress is told in
///   fixes.
/// @param[out] recording The recording, to be freed by beespace_large_recording_free(); NULL after
///   an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code
beespace_large_recording_create(const beespace_out_of_core_options* options,
                                beespace_large_recording** recording, beespace_error* error);
/// @brief Frees a recording, and gives the disk back; no call may be using it.
/// @param recording The recording; NULL does nothing.
BEESPACE_C_API void beespace_large_recording_free(beespace_large_recording* recording);
/// @brief Says how many fixes there are.
/// @param recording The recording.
/// @return The number of fixes; 0 of NULL.
BEESPACE_C_API int64_t beespace_large_recording_size(const beespace_large_recording* recording);

/// @brief Adds fixes, which may be of many agents, and in any order; they are copied to the disk.
/// @param recording The recording.
/// @param fixes The agent and the time of each fix. All fixes have heights, or none has;
///   `height_unit_m` is 0, as the options say it; `climbs_mps` is NULL.
/// @param positions The position of each fix, in metres; how many there are says how many fixes
///   there are.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error:
///   - BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN: a time, a coordinate or a height, with the fix
///     among these in beespace_error::record; none was added;
///   - BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY; none was added;
///   - BEESPACE_WRITE_FAILED: the disk is full, or the folder cannot be written; after that each
///     call returns this error.
BEESPACE_C_API beespace_code beespace_large_recording_add(beespace_large_recording* recording,
                                                          const beespace_fixes* fixes,
                                                          const beespace_points* positions,
                                                          beespace_error* error);

/// @brief Sees conflicts; all arrays are valid during the call.
/// @param data What the search was given.
/// @param first The ids of agents, in ascending order of first, second and begins_s.
/// @param second The ids of the others; above `first`.
/// @param begins_s When each conflict begins, in seconds.
/// @param closest_s When the two are closest in it.
/// @param ends_s When it ends.
/// @param distances_m How close they are then, in metres.
/// @param count How many conflicts there are.
/// @return Other than 0 to go on, 0 to end the search. It must return (not throw, not jump).
typedef int (*beespace_conflicts_visitor)(void* data, const int64_t* first, const int64_t* second,
                                          const double* begins_s, const double* closest_s,
                                          const double* ends_s, const double* distances_m,
                                          int64_t count);
/// @brief Sees gaps, in which it is unknown where an agent is; all arrays are valid during the
/// call.
/// @param data What the search was given.
/// @param agents The ids of agents, in ascending order of ids and times.
/// @param begins_s The time of the fix before each gap, in seconds.
/// @param ends_s The time of the fix after it.
/// @param count How many gaps there are.
/// @return Other than 0 to go on, 0 to end the search. It must return (not throw, not jump).
typedef int (*beespace_gaps_visitor)(void* data, const int64_t* agents, const double* begins_s,
                                     const double* ends_s, int64_t count);

/// @brief Which agents came closer than the threshold to each other, when, and how close? As
/// beespace_recording_conflicts(), bit for bit.
/// @param recording The recording.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL, BEESPACE_MAX_RESULTS.
///   A recording with heights apart must be asked with a vertical threshold, in their unit.
/// @param max_gap_s As of beespace_recording_conflicts().
/// @param run Threads, and what ends the call early; or NULL.
/// @param conflicts Sees the conflicts, after the gaps.
/// @param gaps Sees the gaps. Without conflicts, agents kept their distance but for what may have
///   been in these; or NULL, where `max_gap_s` is INFINITY.
/// @param data What both are called with.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK, also where a visitor ended it; or the code of the error, in which case
///   visitors may have seen some:
///   - BEESPACE_TIME_ORDER: an agent has two fixes at one time; which of all that were added is the
///     second of them is in beespace_error::record;
///   - BEESPACE_INVALID_ARGUMENT: less memory than the threads need, or than the agents that are
///     there at one time need; the message says how much it takes;
///   - BEESPACE_WRITE_FAILED, BEESPACE_READ_FAILED: of the temporary file, also where the folder
///     has too little room;
///   - BEESPACE_CORRUPT: it does not hold what was written;
///   - BEESPACE_INVALID_THRESHOLD, BEESPACE_TOO_MANY_RESULTS, BEESPACE_STOPPED,
///     BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_large_recording_conflicts(
    beespace_large_recording* recording, const beespace_search* search, double max_gap_s,
    const beespace_run* run, beespace_conflicts_visitor conflicts, beespace_gaps_visitor gaps,
    void* data, beespace_error* error);

/// @brief What the last search of a recording went through.
typedef struct beespace_large_recording_facts {
  size_t struct_size;      ///< sizeof(beespace_large_recording_facts), set by the caller.
  int64_t windows;         ///< Windows with fixes.
  int64_t copies;          ///< How many more fixes were written than there are.
  int64_t largest_window;  ///< The fixes of the fullest window.
  int64_t encounters;      ///< 1 where two agents are known at the same time, else 0.
} beespace_large_recording_facts;

/// @brief Says what the last search went through.
/// @param recording The recording.
/// @param[out] facts The facts; all zero before the first search.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK, or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code
beespace_large_recording_facts_of(const beespace_large_recording* recording,
                                  beespace_large_recording_facts* facts, beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
