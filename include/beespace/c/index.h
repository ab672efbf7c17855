/// @file
/// @brief Which points are around any place? Points come, move and go. Part of <beespace.h>.
#ifndef BEESPACE_C_INDEX_H
#define BEESPACE_C_INDEX_H

#include <beespace/c/basics.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief Points by id, in memory of its own, for questions about any position; points can be
/// inserted, moved and removed.
typedef struct beespace_index beespace_index;

/// @brief Builds an index of points, under the ids 0, 1, 2, ...
///
/// Some 80 nanoseconds and 50 bytes a point.
///
/// @param points The points; copied.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] index The index, to be freed by beespace_index_free(); NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_at_risk(), but for the threshold.
BEESPACE_C_API beespace_code beespace_index_create(const beespace_points* points,
                                                   const beespace_run* run, beespace_index** index,
                                                   beespace_error* error);
/// @brief Frees an index; no call may be using it.
/// @param index The index; NULL does nothing.
BEESPACE_C_API void beespace_index_free(beespace_index* index);
/// @brief Says how many points there are now.
/// @param index The index.
/// @return The number of points; 0 of NULL.
BEESPACE_C_API int64_t beespace_index_size(const beespace_index* index);
/// @brief Gives the position of a point.
/// @param index The index.
/// @param id The id of the point.
/// @param[out] position Three coordinates in metres.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT where there is no such point.
BEESPACE_C_API beespace_code beespace_index_position(const beespace_index* index, int64_t id,
                                                     double position[3], beespace_error* error);
/// @brief Which points are around each of many positions?
///
/// Some hundred nanoseconds a position, and a few a point that is found.
///
/// @param index The index.
/// @param places The positions, each of which has a row.
/// @param search The radius as `threshold_m`; 0 is one, too. Flags: BEESPACE_INCLUSIVE,
///   BEESPACE_MAX_RESULTS.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result A row of ids for each position, ascending.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_pairs().
BEESPACE_C_API beespace_code beespace_index_around(const beespace_index* index,
                                                   const beespace_points* places,
                                                   const beespace_search* search,
                                                   const beespace_run* run, beespace_result* result,
                                                   beespace_error* error);
/// @brief Which points are around each of many positions, with a radius for each?
/// @param index The index.
/// @param places The positions, each of which has a row.
/// @param radii_m A radius in metres for each position: 0 or more, `places->count` of them.
/// @param search `threshold_m` must be 0. Flags: BEESPACE_INCLUSIVE, BEESPACE_MAX_RESULTS.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result A row of ids for each position, ascending.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_index_around();
///   BEESPACE_INVALID_THRESHOLD with the place "radii" and the radius in beespace_error::record.
BEESPACE_C_API beespace_code
beespace_index_around_each(const beespace_index* index, const beespace_points* places,
                           const double* radii_m, const beespace_search* search,
                           const beespace_run* run, beespace_result* result, beespace_error* error);
/// @brief Which are the k nearest points of each of many positions?
/// @param index The index.
/// @param places The positions, each of which has a row.
/// @param k How many points to find for each position; 0 or more.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result Rows as of beespace_nearest().
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_nearest().
BEESPACE_C_API beespace_code beespace_index_nearest(const beespace_index* index,
                                                    const beespace_points* places, int64_t k,
                                                    const beespace_run* run,
                                                    beespace_result* result, beespace_error* error);
/// @brief Adds a point, under the next id that was never used.
/// @param index The index.
/// @param position Three coordinates in metres.
/// @param[out] id The id of the point; or NULL.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN, BEESPACE_TOO_MANY_POINTS,
///   BEESPACE_OUT_OF_MEMORY, BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_index_insert(beespace_index* index, const double position[3],
                                                   int64_t* id, beespace_error* error);
/// @brief Moves a point.
/// @param index The index.
/// @param id The id of the point.
/// @param position Three coordinates in metres.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; BEESPACE_INVALID_ARGUMENT where there is no such point; or as
///   beespace_index_insert().
BEESPACE_C_API beespace_code beespace_index_move(beespace_index* index, int64_t id,
                                                 const double position[3], beespace_error* error);
/// @brief Removes a point.
/// @param index The index.
/// @param id The id of the point; it is not used again.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT where there is no such point.
BEESPACE_C_API beespace_code beespace_index_remove(beespace_index* index, int64_t id,
                                                   beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
