/// @file
/// @brief The same questions of more points than fit into memory. Part of <beespace.h>.
#ifndef BEESPACE_C_OUT_OF_CORE_H
#define BEESPACE_C_OUT_OF_CORE_H

#include <beespace/c/basics.h>
#include <beespace/c/search.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief What a search out of core is at, for beespace_out_of_core_options::progress.
enum beespace_out_of_core_phases {
  BEESPACE_DISTRIBUTING = 0,  ///< Points are written to the cells in whose search they take part.
  BEESPACE_SEARCHING = 1      ///< One cell after the other is searched.
};

/// @brief How much memory a search out of core may use, and where its temporary file goes.
typedef struct beespace_out_of_core_options {
  size_t struct_size;     ///< sizeof(beespace_out_of_core_options)
  uint64_t memory_bytes;  ///< 16 MiB for each thread, or more. There is no default. Points that are
                          ///< referred to do not count.
  /// @brief The folder of the temporary file, which has no name and is gone when the program ends,
  /// however it ends. It must have room for some 30 bytes a point, and for another 24 of each that
  /// is added; with heights for 8 more, each time. There is no default.
  const char* folder;
  double height_unit_m;  ///< The length in metres of one unit of heights that are apart from
                         ///< positions, and of their vertical threshold; 0 is 1.
  /// @brief Called some times a second while a search goes on, by one thread at a time, not always
  /// the calling one: beespace_out_of_core_phases, how many points are done, and of how many. It
  /// must return (not throw, not jump). Or NULL.
  void (*progress)(void* data, int32_t phase, int64_t done, int64_t of);
  void* progress_data;  ///< What `progress` is called with.
  uint64_t reserved;    ///< Zero.
} beespace_out_of_core_options;

/// @brief Points beyond memory, under the ids 0, 1, 2, ... in the order in which they come.
typedef struct beespace_out_of_core beespace_out_of_core;

/// @brief Makes a search of no points yet.
/// @param options The memory and the folder.
/// @param[out] out_of_core The search, to be freed by beespace_out_of_core_free(); NULL after an
///   error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code
beespace_out_of_core_create(const beespace_out_of_core_options* options,
                            beespace_out_of_core** out_of_core, beespace_error* error);
/// @brief Frees a search, and gives the disk back; no call may be using it.
/// @param out_of_core The search; NULL does nothing.
BEESPACE_C_API void beespace_out_of_core_free(beespace_out_of_core* out_of_core);
/// @brief Says how many points there are.
/// @param out_of_core The search.
/// @return The number of points; 0 of NULL.
BEESPACE_C_API int64_t beespace_out_of_core_size(const beespace_out_of_core* out_of_core);

/// @brief Adds points, which are copied to the disk.
/// @param out_of_core The search.
/// @param points The points.
/// @param heights_m A height for each of them, one after the other, apart from its position, which
///   is then horizontal: for a vertical threshold between points whose third axis is not the
///   height. In the unit of the options. NULL where heights are z. All points have them, or none.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error, in which case none was added:
///   - BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN: a coordinate or height, with its place among
///     `points` in beespace_error::record;
///   - BEESPACE_WRITE_FAILED: the disk is full, or the folder cannot be written;
///   - BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_out_of_core_add(beespace_out_of_core* out_of_core,
                                                      const beespace_points* points,
                                                      const double* heights_m,
                                                      beespace_error* error);
/// @brief Adds points that stay where they are: in a mapped file, say. They and their heights must
/// outlive the search, and must not change.
/// @param out_of_core The search.
/// @param points The points, as of beespace_out_of_core_add(); the structure itself is not kept.
/// @param heights_m As of beespace_out_of_core_add().
/// @param[out] error What went wrong; or NULL.
/// @return As beespace_out_of_core_add(); coordinates and heights are checked by the searches.
BEESPACE_C_API beespace_code beespace_out_of_core_refer(beespace_out_of_core* out_of_core,
                                                        const beespace_points* points,
                                                        const double* heights_m,
                                                        beespace_error* error);

/// @brief Sees ids.
/// @param data What the search was given.
/// @param ids Ids in ascending order; valid during the call.
/// @param count How many there are.
/// @return Other than 0 to go on, 0 to end the search. It must return (not throw, not jump).
typedef int (*beespace_ids_visitor)(void* data, const int64_t* ids, int64_t count);

/// @brief Which points are closer than the threshold to any other point? As beespace_at_risk().
/// @param out_of_core The search.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL.
/// @param run Threads, and what ends the call early; or NULL.
/// @param visit Sees the ids of the points at risk, those of one cell a call. It is called by one
///   thread at a time, not always the same.
/// @param data What `visit` is called with.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK, also where `visit` ended it; or the code of the error, in which case
/// `visit`
///   may have seen some:
///   - those of beespace_at_risk(); of a coordinate or height that is none, with the id in
///     beespace_error::record;
///   - BEESPACE_WRITE_FAILED, BEESPACE_READ_FAILED: of the temporary file, also where the folder
///   has
///     too little room;
///   - BEESPACE_CORRUPT: it does not hold what was written;
///   - BEESPACE_INVALID_ARGUMENT: less memory than the threads need.
BEESPACE_C_API beespace_code beespace_out_of_core_at_risk(beespace_out_of_core* out_of_core,
                                                          const beespace_search* search,
                                                          const beespace_run* run,
                                                          beespace_ids_visitor visit, void* data,
                                                          beespace_error* error);

/// @brief Which pairs of points are closer than the threshold? As beespace_visit_pairs().
/// @param out_of_core The search.
/// @param search The threshold. Flags: BEESPACE_INCLUSIVE, BEESPACE_VERTICAL, BEESPACE_DISTANCES.
/// @param run Threads, and what ends the call early; or NULL.
/// @param visit Sees each pair once with first < second, in no particular order. It is called by
///   one thread at a time, not always the same. Distances of points with heights apart from their
///   positions are the root of the sum of both squares, in metres.
/// @param data What `visit` is called with.
/// @param[out] error What went wrong; or NULL.
/// @return As beespace_out_of_core_at_risk().
BEESPACE_C_API beespace_code beespace_out_of_core_pairs(beespace_out_of_core* out_of_core,
                                                        const beespace_search* search,
                                                        const beespace_run* run,
                                                        beespace_pair_visitor visit, void* data,
                                                        beespace_error* error);

/// @brief Sees ids, and a count for each of them.
/// @param data What the search was given.
/// @param ids Ids in ascending order; valid during the call.
/// @param counts How many neighbours each of them has; valid during the call.
/// @param count How many ids there are.
/// @return Other than 0 to go on, 0 to end the search. It must return (not throw, not jump).
typedef int (*beespace_counts_visitor)(void* data, const int64_t* ids, const int64_t* counts,
                                       int64_t count);

/// @brief How many points are closer than the threshold to each point? As beespace_count().
/// @param out_of_core The search.
/// @param search As of beespace_out_of_core_at_risk().
/// @param run Threads, and what ends the call early; or NULL.
/// @param visit Sees each point once, those of one cell or a part of it a call. It is called by one
///   thread at a time, not always the same.
/// @param data What `visit` is called with.
/// @param[out] error What went wrong; or NULL.
/// @return As beespace_out_of_core_at_risk().
BEESPACE_C_API beespace_code beespace_out_of_core_count(beespace_out_of_core* out_of_core,
                                                        const beespace_search* search,
                                                        const beespace_run* run,
                                                        beespace_counts_visitor visit, void* data,
                                                        beespace_error* error);

/// @brief Sees ids, and a row of neighbours for each of them, all of one length.
/// @param data What the search was given.
/// @param ids Ids; valid during the call.
/// @param rows How many ids there are.
/// @param nearest The nearest points of the first id, then those of the next: `rows * length` ids,
///   in each row beginning with the nearest; valid during the call.
/// @param distances_m Their distances in metres; valid during the call.
/// @param length How many there are in each row.
/// @return Other than 0 to go on, 0 to end the search. It must return (not throw, not jump).
typedef int (*beespace_nearest_visitor)(void* data, const int64_t* ids, int64_t rows,
                                        const int64_t* nearest, const double* distances_m,
                                        int64_t length);

/// @brief Which are the k nearest other points of each point, however far? As beespace_nearest().
/// @param out_of_core The search, of points without heights apart from their positions.
/// @param k How many to find for each point; 0 or more.
/// @param run Threads, and what ends the call early; or NULL.
/// @param visit Sees each point once, with `k` neighbours, or one fewer than there are points where
///   that is less. It is not called where `k` is 0 or there are fewer than two points. It is called
///   by one thread at a time, not always the same.
/// @param data What `visit` is called with.
/// @param[out] error What went wrong; or NULL.
/// @return As beespace_out_of_core_at_risk(), but for the threshold.
BEESPACE_C_API beespace_code beespace_out_of_core_nearest(beespace_out_of_core* out_of_core,
                                                          int64_t k, const beespace_run* run,
                                                          beespace_nearest_visitor visit,
                                                          void* data, beespace_error* error);

/// @brief Which two points are closest to each other? As beespace_closest_pair().
/// @param out_of_core The search, of points without heights apart from their positions.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] result One pair with its distance; none of fewer than two points.
/// @param[out] error What went wrong; or NULL.
/// @return As beespace_out_of_core_at_risk(), but for the threshold.
BEESPACE_C_API beespace_code beespace_out_of_core_closest_pair(beespace_out_of_core* out_of_core,
                                                               const beespace_run* run,
                                                               beespace_result* result,
                                                               beespace_error* error);

/// @brief How the last search was cut.
typedef struct beespace_out_of_core_facts {
  size_t struct_size;     ///< sizeof(beespace_out_of_core_facts), set by the caller.
  int64_t cells;          ///< Cells with points.
  int64_t copies;         ///< Points in halos: how many more were written than there are.
  int64_t crowded_cells;  ///< Cells that are too full for the memory: searched in pieces, each with
                          ///< each, which takes longer.
  int64_t largest_cell;   ///< The points of the fullest cell, its halo included.
} beespace_out_of_core_facts;

/// @brief Says how the last search was cut.
/// @param out_of_core The search.
/// @param[out] facts The facts; all zero before the first search.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK, or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_out_of_core_facts_of(const beespace_out_of_core* out_of_core,
                                                           beespace_out_of_core_facts* facts,
                                                           beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
