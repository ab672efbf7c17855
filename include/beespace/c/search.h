/// @file
/// @brief Which points are closer than a threshold to which others, and which are nearest? Part of
/// <beespace.h>.
#ifndef BEESPACE_C_SEARCH_H
#define BEESPACE_C_SEARCH_H

#include <beespace/c/basics.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief Working memory and threads that are kept from call to call. A call with the engine of an
/// earlier similar call allocates nothing.
typedef struct beespace_engine beespace_engine;

/// @brief Makes an engine.
/// @return The engine; NULL when there is no memory.
BEESPACE_C_API beespace_engine* beespace_engine_create(void);
/// @brief Frees an engine; no call may be using it.
/// @param engine The engine; NULL does nothing.
BEESPACE_C_API void beespace_engine_free(beespace_engine* engine);
/// @brief Gives the working memory of an engine back to the system; the engine can still be used.
/// @param engine The engine; NULL does nothing.
BEESPACE_C_API void beespace_engine_release_memory(beespace_engine* engine);

/// @brief Which points are closer than the threshold to any other point?
///
/// Time and memory grow with the number of points: some tens of nanoseconds and at most 48 bytes
/// each (120 where points spread over more than 2^20 thresholds), besides the answer.
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param points The points of which ids are returned.
/// @param others NULL: compared with each other. Else compared with these, and only with these.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result The ids of the points at risk, ascending.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error:
///   - BEESPACE_INVALID_THRESHOLD: of `threshold_m` or `vertical_m`;
///   - BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN: a coordinate, with its point in
///     beespace_error::record;
///   - BEESPACE_INVALID_ARGUMENT, BEESPACE_TOO_MANY_POINTS, BEESPACE_STOPPED,
///     BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_at_risk(beespace_engine* engine,
                                              const beespace_points* points,
                                              const beespace_points* others,
                                              const beespace_search* search,
                                              const beespace_run* run, beespace_result* result,
                                              beespace_error* error);

/// @brief Which pairs of points are closer than the threshold?
///
/// Some tens of nanoseconds a point and ten to thirty a pair; 40 bytes a point and 16 a pair,
/// besides the answer.
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param points The points.
/// @param others NULL: pairs of `points`, each once, with first < second. Else pairs of one of
///   `points` and one of these.
/// @param search The threshold. Flags: all but BEESPACE_WITH_SELF.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result first and second in ascending order, distances with BEESPACE_DISTANCES.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_at_risk(), and
///   BEESPACE_TOO_MANY_RESULTS.
BEESPACE_C_API beespace_code beespace_pairs(beespace_engine* engine, const beespace_points* points,
                                            const beespace_points* others,
                                            const beespace_search* search, const beespace_run* run,
                                            beespace_result* result, beespace_error* error);

/// @brief Sees a batch of pairs.
/// @param data What beespace_visit_pairs() was given.
/// @param first The first point of each pair; valid during the call.
/// @param second The second point of each pair; valid during the call.
/// @param distances_m Their distances with BEESPACE_DISTANCES, else NULL; valid during the call.
/// @param count How many pairs there are; at most 4096.
/// @return Other than 0 to go on, 0 to end the search. It must return (not throw, not jump).
typedef int (*beespace_pair_visitor)(void* data, const int64_t* first, const int64_t* second,
                                     const double* distances_m, int64_t count);

/// @brief Shows all pairs of points that are closer than the threshold to a visitor, and keeps
/// none.
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param points The points.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL, BEESPACE_DISTANCES.
/// @param run Threads, and what ends the call early; or NULL.
/// @param visit Sees each pair once with first < second, in no particular order. It is called by
///   one thread at a time, not always the same.
/// @param data What `visit` is called with.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK, also where `visit` ended it; or the code of the error: as
///   beespace_at_risk().
BEESPACE_C_API beespace_code beespace_visit_pairs(
    beespace_engine* engine, const beespace_points* points, const beespace_search* search,
    const beespace_run* run, beespace_pair_visitor visit, void* data, beespace_error* error);

/// @brief Which points are closer than the threshold to each point?
///
/// Some tens of nanoseconds a point and about ten a neighbour; 48 bytes a point and 12 a neighbour,
/// besides the answer.
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param points The points, each of which has a row.
/// @param others NULL: neighbours are other `points`. Else neighbours are of these.
/// @param search The threshold. Flags: all; BEESPACE_WITH_SELF only where `others` is NULL.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result A row of ids for each point, ascending; distances with BEESPACE_DISTANCES.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_pairs().
BEESPACE_C_API beespace_code beespace_neighbors(beespace_engine* engine,
                                                const beespace_points* points,
                                                const beespace_points* others,
                                                const beespace_search* search,
                                                const beespace_run* run, beespace_result* result,
                                                beespace_error* error);

/// @brief How many points are closer than the threshold to each point?
///
/// As beespace_neighbors() without the rows: 44 bytes a point, besides the answer.
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param points The points, each of which has a count.
/// @param others NULL: other `points` are counted. Else these.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL; BEESPACE_WITH_SELF
///   only where `others` is NULL.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result A count for each point.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_at_risk().
BEESPACE_C_API beespace_code beespace_count(beespace_engine* engine, const beespace_points* points,
                                            const beespace_points* others,
                                            const beespace_search* search, const beespace_run* run,
                                            beespace_result* result, beespace_error* error);

/// @brief Which points must be considered together to separate them: the connected components of
/// "closer than the threshold".
///
/// Time as beespace_pairs(), but crowds cost no more than other points.
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param points The points.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result A row for each group: the ids of its members, ascending. Groups stand in the
///   order of their lowest member; points that are not at risk are in no group.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_at_risk().
BEESPACE_C_API beespace_code beespace_groups(beespace_engine* engine, const beespace_points* points,
                                             const beespace_search* search, const beespace_run* run,
                                             beespace_result* result, beespace_error* error);

/// @brief Which are the k nearest points of each point, however far?
///
/// Some hundred nanoseconds a point and some tens a neighbour; at most 104 bytes a point,
/// besides 16 bytes a neighbour and the answer.
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param points The points, each of which has a row.
/// @param others NULL: neighbours are other `points`. Else neighbours are of these.
/// @param k How many neighbours to find for each point; 0 or more.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result A row of ids and distances for each point, in the order of distances, equally
///   near ones in the order of ids. Each row has k entries, or as many as there are where that is
///   less: rows may be empty.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_at_risk(), but for the threshold.
BEESPACE_C_API beespace_code beespace_nearest(beespace_engine* engine,
                                              const beespace_points* points,
                                              const beespace_points* others, int64_t k,
                                              const beespace_run* run, beespace_result* result,
                                              beespace_error* error);

/// @brief Which is the nearest point of each point, of those that are closer than the threshold?
///
/// With a vertical threshold it is the nearest by the straight line.
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param points The points, each of which has an entry.
/// @param others NULL: it is one of the other `points`. Else one of these.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result An id and a distance for each point; -1 and infinity where there is none.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_at_risk().
BEESPACE_C_API beespace_code
beespace_nearest_within(beespace_engine* engine, const beespace_points* points,
                        const beespace_points* others, const beespace_search* search,
                        const beespace_run* run, beespace_result* result, beespace_error* error);

/// @brief Which two points are closest to each other?
///
/// A few tens of nanoseconds a point, expected.
///
/// @param engine Keeps memory and threads for the next call; or NULL.
/// @param points The points.
/// @param others NULL: both are of `points`. Else the second one is of these.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result One pair with its distance, of equally close ones the lowest; no pair where
///   there are too few points.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_at_risk(), but for the threshold.
BEESPACE_C_API beespace_code beespace_closest_pair(beespace_engine* engine,
                                                   const beespace_points* points,
                                                   const beespace_points* others,
                                                   const beespace_run* run, beespace_result* result,
                                                   beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
