/// @file
/// @brief Codes, errors, points, what is asked, how a call is ended, and answers in columns. Part
/// of <beespace.h>.
#ifndef BEESPACE_C_BASICS_H
#define BEESPACE_C_BASICS_H

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
enum beespace_codes {
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
  int64_t record;      ///< The index into `place` that it is about; -1 where it is about none. Of a
                       ///< guide or follower, where `place` is "agents": the number of the agent.
  char place[32];      ///< The argument that it is about: "points", "others", ...; or empty.
  char message[512];   ///< One sentence: what is wrong and what to do. Ends with a zero byte.
} beespace_error;

/// @brief Says the version of the library in use.
/// @return "MAJOR.MINOR.PATCH". Valid for ever.
BEESPACE_C_API const char* beespace_version(void);

/* ---- What is asked -------------------------------------------------------------------------- */

/// @brief The types of coordinates, for beespace_points::type.
enum beespace_number_types {
  BEESPACE_FLOAT64 = 0,  ///< double
  BEESPACE_FLOAT32 = 1   ///< float; converted to double when it is read, which is exact.
};

/// @brief Points in the caller's memory, whatever their layout. Nothing is copied.
///
/// They must not change during a call, which reads them more than once: not even values that other
/// threads write may change, or the answer is wrong or the process crashes.
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
enum beespace_search_flags {
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

#ifdef __cplusplus
}
#endif

#endif
