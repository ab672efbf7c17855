/// @file
/// @brief beespace for C, and for each language that can call C: which points are closer than a
/// threshold to which others?
///
/// C99. The comparisons are those of the C++ library: of real numbers, on the given values. No
/// rounding, machine or number of threads changes an answer.
///
/// Units: metres, in any Cartesian frame; seconds, metres per second. Ids are indices of the
/// caller's points, from 0.
///
/// Structures begin with their size, so that they can grow in later versions. Fill the rest with
/// zeros: zero means the default wherever there is one.
///
///     beespace_search search = {.struct_size = sizeof search, .threshold_m = 50.0};
///
/// Errors: a function that can fail returns a #beespace_code, and writes what is wrong into the
/// caller's beespace_error, if one is given. A result is empty after an error. No function prints,
/// aborts, throws, or keeps anything between calls besides what its handles hold.
///
/// Ownership: what a `..._create` function returns belongs to the caller, until the `..._free`
/// function of its type; to free NULL does nothing. Points and structures are read during the call
/// and not kept; they must not change while a call reads them.
///
/// Thread safety: any number of threads may call at the same time, with handles of their own. An
/// engine and a result serve one call at a time. An index may be asked by many threads at the same
/// time, while none changes it. A stop may be used by all threads.
#ifndef BEESPACE_H
#define BEESPACE_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
/// @brief Marks what the shared library exports.
#define BEESPACE_C_API __attribute__((visibility("default")))
#else
/// @brief Marks what the shared library exports.
#define BEESPACE_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Codes ---------------------------------------------------------------------------------- */

/// @brief What became of a call: BEESPACE_OK, or the kind of its error.
typedef int32_t beespace_code;

/// @brief The codes. A number never changes its meaning; later versions may add some.
enum {
  BEESPACE_OK = 0,                   ///< The call succeeded.
  BEESPACE_INVALID_THRESHOLD = 1,    ///< A threshold that is not given, not finite, or not above 0.
  BEESPACE_INVALID_ARGUMENT = 2,     ///< Any other argument that makes no sense.
  BEESPACE_NOT_FINITE = 3,           ///< A NaN or an infinity among the coordinates.
  BEESPACE_OUTSIDE_DOMAIN = 4,       ///< A coordinate above 2^400, or below 2^-400 and not zero.
  BEESPACE_TOO_MANY_POINTS = 5,      ///< More than 4,294,963,200 points.
  BEESPACE_TOO_MANY_RESULTS = 6,     ///< More results than beespace_search::max_results.
  BEESPACE_INVALID_LATITUDE = 7,     ///< A latitude beyond +-90 degrees.
  BEESPACE_INVALID_LONGITUDE = 8,    ///< A longitude beyond +-360 degrees.
  BEESPACE_INVALID_HEIGHT = 9,       ///< A height that is not near the Earth.
  BEESPACE_TIME_ORDER = 10,          ///< A time that does not come after the one before it.
  BEESPACE_CANNOT_OPEN = 11,         ///< A file that is missing or not readable.
  BEESPACE_READ_FAILED = 12,         ///< The system failed in the middle of reading.
  BEESPACE_NO_POINTS = 13,           ///< A file without points.
  BEESPACE_MISSING_COLUMN = 14,      ///< A column that is needed is not there.
  BEESPACE_NOT_A_NUMBER = 15,        ///< A field that should hold a number holds something else.
  BEESPACE_COLUMN_COUNT = 16,        ///< A record with another number of columns.
  BEESPACE_MALFORMED_RECORD = 17,    ///< A record that is none.
  BEESPACE_UNKNOWN_FRAME = 18,       ///< Degrees or metres? The data does not say.
  BEESPACE_UNSUPPORTED_FORMAT = 19,  ///< A format that beespace does not read.
  BEESPACE_TRUNCATED = 20,           ///< A file that ends too early.
  BEESPACE_CORRUPT = 21,             ///< Damaged data.
  BEESPACE_WRITE_FAILED = 22,        ///< A full disk, a missing folder, no permission.
  BEESPACE_STOPPED = 23,             ///< A stop was requested before the answer was complete.
  BEESPACE_OUT_OF_MEMORY = 100,      ///< The system gives no more memory.
  BEESPACE_INTERNAL = 101            ///< A fault of beespace itself: please report it.
};

/// @brief Names a code as the command does: "invalid_threshold", "out_of_memory", ...
/// @param code The code.
/// @return Its name; "ok" for BEESPACE_OK, "unknown" for a number that is no code. Valid for ever.
BEESPACE_C_API const char* beespace_code_name(beespace_code code);

/// @brief What went wrong, where, and what to do about it. The caller's; a call that fails fills
/// it, a call that succeeds leaves it as it was.
typedef struct beespace_error {
  size_t struct_size;  ///< sizeof(beespace_error), set by the caller.
  beespace_code code;  ///< The kind of the error.
  int32_t reserved;    ///< Zero.
  int64_t record;      ///< The index into `place` that it is about; -1 where it is about none.
  char place[32];      ///< The argument that it is about: "points", "others", ...; or empty.
  char message[512];   ///< One sentence: what is wrong and what to do. Ends with a zero byte.
} beespace_error;

/// @brief Says the version of the library in use.
/// @return "MAJOR.MINOR.PATCH". Valid for ever.
BEESPACE_C_API const char* beespace_version(void);

/* ---- What is asked -------------------------------------------------------------------------- */

/// @brief The types of coordinates, for beespace_points::type.
enum {
  BEESPACE_FLOAT64 = 0,  ///< double
  BEESPACE_FLOAT32 = 1   ///< float; converted to double when it is read, which is exact.
};

/// @brief Points in the caller's memory, whatever their layout. Nothing is copied.
///
/// Coordinate `x` of point i stands `i * x_stride` bytes behind `x`. Strides may be negative; 0
/// repeats one coordinate for all points. Pointers and strides must be multiples of the size that
/// the type is aligned to: packed structures must be copied first.
typedef struct beespace_points {
  size_t struct_size;  ///< sizeof(beespace_points)
  int32_t type;        ///< BEESPACE_FLOAT64 or BEESPACE_FLOAT32.
  int32_t reserved;    ///< Zero.
  int64_t count;       ///< How many points there are.
  const void* x;       ///< The first coordinate of the first point, in metres.
  const void* y;       ///< The second coordinate of the first point, in metres.
  const void* z;       ///< The third one; NULL for points in a plane, whose z is 0.
  ptrdiff_t x_stride;  ///< Bytes from one x to the next.
  ptrdiff_t y_stride;  ///< Bytes from one y to the next.
  ptrdiff_t z_stride;  ///< Bytes from one z to the next; not read where `z` is NULL.
} beespace_points;

/// @brief Points of doubles that are interleaved: x0 y0 z0 x1 y1 z1 ...
/// @param xyz The coordinates in metres, 3 * count of them; they must outlive the structure.
/// @param count How many points there are.
/// @return The structure.
static inline beespace_points beespace_points_interleaved(const double* xyz, int64_t count) {
  beespace_points points = {
      sizeof(beespace_points), BEESPACE_FLOAT64,  0, 0, NULL, NULL, NULL, 3 * sizeof(double),
      3 * sizeof(double),      3 * sizeof(double)};
  points.count = count;
  if (count > 0 && xyz != NULL) {
    points.x = xyz;
    points.y = xyz + 1;
    points.z = xyz + 2;
  }
  return points;
}

/// @brief Points of doubles in one array for each axis.
/// @param x The first coordinates in metres, `count` of them; they must outlive the structure.
/// @param y The second coordinates in metres.
/// @param z The third coordinates in metres; or NULL for points in a plane.
/// @param count How many points there are.
/// @return The structure.
static inline beespace_points beespace_points_separate(const double* x, const double* y,
                                                       const double* z, int64_t count) {
  beespace_points points = {
      sizeof(beespace_points), BEESPACE_FLOAT64, 0, 0, NULL, NULL, NULL, sizeof(double),
      sizeof(double),          sizeof(double)};
  points.count = count;
  points.x = x;
  points.y = y;
  points.z = z;
  return points;
}

/// @brief The flags of beespace_search::flags, to be joined by `|`.
enum {
  BEESPACE_INCLUSIVE = 1,    ///< Points exactly the threshold apart count, too: "<=", not "<".
  BEESPACE_VERTICAL = 2,     ///< beespace_search::vertical_m holds a vertical threshold.
  BEESPACE_MAX_RESULTS = 4,  ///< beespace_search::max_results holds a limit.
  BEESPACE_DISTANCES = 8,    ///< The distance of each pair or neighbour is wanted, too.
  BEESPACE_WITH_SELF = 16    ///< Each point is a neighbour of itself, too.
};

/// @brief What a search with a threshold needs to know. A flag that a function does not know is an
/// error, BEESPACE_INVALID_ARGUMENT.
typedef struct beespace_search {
  size_t struct_size;    ///< sizeof(beespace_search)
  uint32_t flags;        ///< BEESPACE_INCLUSIVE | ...
  uint32_t reserved;     ///< Zero.
  double threshold_m;    ///< The threshold in metres, above zero. There is no default.
  double vertical_m;     ///< With BEESPACE_VERTICAL: two points conflict when they are closer than
                         ///< the threshold in x and y, and closer than this in z.
  uint64_t max_results;  ///< With BEESPACE_MAX_RESULTS: more pairs, or neighbours in all rows
                         ///< together, are an error, BEESPACE_TOO_MANY_RESULTS. No answer is cut.
} beespace_search;

/// @brief Ends calls early. See beespace_stop_request().
typedef struct beespace_stop beespace_stop;

/// @brief beespace_run::threads: one for each processor.
#define BEESPACE_ALL_PROCESSORS 0xFFFFFFFFu

/// @brief How much of the machine a call uses, and what ends it early. Where a function takes a
/// pointer to one, NULL is as good as one of zeros.
typedef struct beespace_run {
  size_t struct_size;   ///< sizeof(beespace_run)
  uint32_t threads;     ///< How many threads may work; 0 is 1. The answer is always the same.
  uint32_t reserved;    ///< Zero.
  beespace_stop* stop;  ///< What other threads end the call with; or NULL.
  /// @brief Called on the calling thread some 20 times a second while the call takes long; a return
  /// of other than 0 ends it, with BEESPACE_STOPPED in any case. For languages that hear of Ctrl-C
  /// on one thread only. It must return (not throw, not jump). The search then runs on other
  /// threads. Or NULL.
  int (*poll)(void* data);
  void* poll_data;  ///< What `poll` is called with.
} beespace_run;

/// @brief Makes a stop that is not requested.
/// @return The stop; NULL when there is no memory.
BEESPACE_C_API beespace_stop* beespace_stop_create(void);
/// @brief Requests that all calls with this stop end soon, with BEESPACE_STOPPED. For good: calls
/// that begin later end, too.
/// @param stop The stop; NULL does nothing.
BEESPACE_C_API void beespace_stop_request(beespace_stop* stop);
/// @brief Frees a stop; no call may be using it.
/// @param stop The stop; NULL does nothing.
BEESPACE_C_API void beespace_stop_free(beespace_stop* stop);

/* ---- Answers -------------------------------------------------------------------------------- */

/// @brief An answer, in columns. Each call that is given the result overwrites it, and keeps its
/// memory for the next one. Arrays belong to the result, and are valid until its next call or end.
typedef struct beespace_result beespace_result;

/// @brief Makes an empty result.
/// @return The result; NULL when there is no memory.
BEESPACE_C_API beespace_result* beespace_result_create(void);
/// @brief Frees a result and its arrays.
/// @param result The result; NULL does nothing.
BEESPACE_C_API void beespace_result_free(beespace_result* result);
/// @brief Says how many entries its columns have: ids, pairs, counts, or neighbours in all rows.
/// @param result The result.
/// @return The number of entries.
BEESPACE_C_API int64_t beespace_result_size(const beespace_result* result);
/// @brief Says how many rows there are, of an answer in rows.
/// @param result The result.
/// @return The number of rows; 0 of an answer that has none.
BEESPACE_C_API int64_t beespace_result_rows(const beespace_result* result);
/// @brief Gives the ids: those at risk, of neighbours, of members of groups, of nearest points.
/// @param result The result.
/// @return beespace_result_size() ids; NULL of an answer without this column, or of no entry.
BEESPACE_C_API const int64_t* beespace_result_ids(const beespace_result* result);
/// @brief Gives where rows begin: row r has the entries offsets[r] to offsets[r + 1] - 1.
/// @param result The result.
/// @return beespace_result_rows() + 1 offsets, the first of them 0; NULL of an answer without rows.
BEESPACE_C_API const int64_t* beespace_result_offsets(const beespace_result* result);
/// @brief Gives the first point of each pair.
/// @param result The result.
/// @return beespace_result_size() ids; NULL of an answer without pairs.
BEESPACE_C_API const int64_t* beespace_result_first(const beespace_result* result);
/// @brief Gives the second point of each pair.
/// @param result The result.
/// @return beespace_result_size() ids; NULL of an answer without pairs.
BEESPACE_C_API const int64_t* beespace_result_second(const beespace_result* result);
/// @brief Gives the number of neighbours of each point.
/// @param result The result.
/// @return beespace_result_size() counts; NULL of an answer that is not of beespace_count().
BEESPACE_C_API const int64_t* beespace_result_counts(const beespace_result* result);
/// @brief Gives the distance in metres of each pair or neighbour: the root of the sum of three
/// squares, each step rounded to the nearest double.
/// @param result The result.
/// @return beespace_result_size() distances; NULL where they were not asked for. Of movers: how
///   close they are when they are closest.
BEESPACE_C_API const double* beespace_result_distances_m(const beespace_result* result);
/// @brief Gives when each conflict begins, in seconds.
/// @param result The result.
/// @return beespace_result_size() times, NaN where there is no conflict; NULL of an answer that is
///   not of movers, or of approaches without a threshold.
BEESPACE_C_API const double* beespace_result_begins_s(const beespace_result* result);
/// @brief Gives when two movers are closest, in seconds.
/// @param result The result.
/// @return beespace_result_size() times; NULL of an answer that is not of movers.
BEESPACE_C_API const double* beespace_result_closest_s(const beespace_result* result);
/// @brief Gives when each conflict ends, in seconds.
/// @param result The result.
/// @return As beespace_result_begins_s().
BEESPACE_C_API const double* beespace_result_ends_s(const beespace_result* result);
/// @brief Says how many gaps a recording has: times in which an agent is somewhere unknown.
/// @param result The result of a question about a recording.
/// @return The number of gaps; 0 of another answer.
BEESPACE_C_API int64_t beespace_result_gaps(const beespace_result* result);
/// @brief Gives the agent of each gap, in ascending order of agent and time.
/// @param result The result.
/// @return beespace_result_gaps() ids of agents; NULL where there is none.
BEESPACE_C_API const int64_t* beespace_result_gap_agents(const beespace_result* result);
/// @brief Gives when each gap begins: the time of the fix before it, in seconds.
/// @param result The result.
/// @return beespace_result_gaps() times; NULL where there is none.
BEESPACE_C_API const double* beespace_result_gap_begins_s(const beespace_result* result);
/// @brief Gives when each gap ends: the time of the fix behind it, in seconds.
/// @param result The result.
/// @return beespace_result_gaps() times; NULL where there is none.
BEESPACE_C_API const double* beespace_result_gap_ends_s(const beespace_result* result);

/* ---- Questions ------------------------------------------------------------------------------ */

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
/// Some hundred nanoseconds a point and about a hundred a neighbour; at most 104 bytes a point,
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

/* ---- Index ---------------------------------------------------------------------------------- */

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

/* ---- Movers --------------------------------------------------------------------------------- */

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

/* ---- Recordings ----------------------------------------------------------------------------- */

/// @brief What is known of agents besides their positions: which one, and when. Nothing is copied;
/// strides are as of beespace_points.
typedef struct beespace_fixes {
  size_t struct_size;       ///< sizeof(beespace_fixes)
  int64_t reserved;         ///< Zero.
  const int64_t* agents;    ///< The agent of each fix: any number is an id.
  const double* times_s;    ///< The time of each fix, in seconds from any moment.
  ptrdiff_t agents_stride;  ///< Bytes from one agent to the next.
  ptrdiff_t times_stride;   ///< Bytes from one time to the next.
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
///   - BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN: a time or a coordinate; likewise;
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
/// @param recording The recording.
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

/* ---- Geodesy -------------------------------------------------------------------------------- */

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

#ifdef __cplusplus
}
#endif

#endif
