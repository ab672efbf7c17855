/// @file
/// @brief Files for C: points, recordings and obstacles out of what other programs write, and pages
/// about them. A library of its own, libbeespace_io.so, beside that of <beespace.h>.
///
/// C99. What is read, and how, is what the command `beespace` does: tables of text in any layout,
/// arrays of NumPy, raw doubles, drone shows, telemetry and PX4 logs, reports of aircraft; each
/// plain or gzip-compressed. Nothing is guessed: where a file does not say whether it holds degrees
/// or metres, or in which unit, reading it is an error that says how to say it.
///
/// Units: metres and seconds, whatever the file has. Longitude, latitude and height become metres
/// of ECEF (earth-centred, earth-fixed), so their z is not a height.
///
/// The conventions are those of <beespace.h>: structures begin with their size, zero means the
/// default, a function that can fail returns a #beespace_code and fills the caller's error. What a
/// function makes belongs to the caller, until the `..._free` function of its type; to free NULL
/// does nothing. What an accessor returns belongs to the handle, is UTF-8 where the file is, ends
/// with a zero byte where it is text, and is valid until the handle is freed. Accessors take NULL
/// as a handle of nothing. Any number of threads may call at the same time; a handle does not
/// change once it is made, so it may be read by many.
///
/// A path names a file: "-" is a file of that name. Standard input is read where it is asked for,
/// as "/dev/stdin". Reading cannot be stopped; the search for a page can.
#ifndef BEESPACE_IO_H
#define BEESPACE_IO_H

#include <beespace.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief Says the version of this library. That of libbeespace.so may be another one.
/// @return "MAJOR.MINOR.PATCH". Valid for ever.
BEESPACE_C_API const char* beespace_io_version(void);

/* ---- Errors --------------------------------------------------------------------------------- */

/// @brief What went wrong with a file, where in it, and what to do about it. The caller's; a call
/// that fails fills it, a call that succeeds leaves it as it was. The codes are those of
/// <beespace.h>, which also names them: beespace_code_name().
///
/// What is too long for its array is cut, with "..." in place of what is missing: at the front of
/// `file`, at the end of `message`.
typedef struct beespace_io_error {
  size_t struct_size;  ///< sizeof(beespace_io_error), set by the caller.
  beespace_code code;  ///< The kind of the error.
  int32_t reserved;    ///< Zero.
  int64_t record;      ///< The row of data, or the index into `place`, from 0; -1 where unknown.
  int64_t line;        ///< The line of the file, from 1; 0 where unknown.
  int64_t column;      ///< The field of the record, from 1; 0 where unknown.
  char place[32];      ///< The argument that it is about: "path", "options", ...; or empty.
  char file[1024];     ///< The file that it is about; or empty. In archives "show.skyc!drone1.json"
  char message[1024];  ///< One sentence: what is wrong and what to do. Options are named as the
                       ///< fields of beespace_io_options, flags in small letters: "skip_bad".
} beespace_io_error;

/// @brief Writes an error in one line, as compilers do: "bees.csv:3:2: 'abc' is not a number ...".
/// @param error The error.
/// @param[out] text Where to; ends with a zero byte, where `size` is not 0.
/// @param size How many bytes there are.
/// @return How many bytes the whole line has, without the zero: `size` or more where it was cut.
BEESPACE_C_API size_t beespace_io_error_text(const beespace_io_error* error, char* text,
                                             size_t size);

/* ---- How a file is read --------------------------------------------------------------------- */

/// @brief The flags of beespace_io_options::flags, to be joined by `|`.
enum {
  BEESPACE_IO_SKIP_BAD = 1,  ///< Bad records are left out and listed, instead of being an error.
  BEESPACE_IO_GROUNDED = 2,  ///< Of recordings: drones and aircraft on the ground count, too.
  BEESPACE_IO_ANY_LIKELIHOOD = 4,  ///< Of tables of poses: places count however unlikely they are.
  BEESPACE_IO_ONE_CLOCK = 8        ///< Of several files whose times do not say since when they
                                   ///< count: all have one clock.
};

/// @brief How a file is to be read, where it does not say so itself. NULL is as good as one of
/// zeros: all is told by the file, and what it does not tell is an error. Texts may be NULL.
typedef struct beespace_io_options {
  size_t struct_size;     ///< sizeof(beespace_io_options)
  uint32_t flags;         ///< BEESPACE_IO_SKIP_BAD | ...
  uint32_t threads;       ///< How many threads may read; 0 is 1, or BEESPACE_ALL_PROCESSORS.
  uint64_t reserved;      ///< Zero.
  const char* frame;      ///< "wgs84": longitude and latitude in degrees; "metres"; "auto".
  const char* columns;    ///< Of tables, by number or name: "id=1,lon=2,lat=3,height=4".
  const char* units;      ///< What no header names: "position=km,height=ft,speed=kt,climb=ft/min".
  const char* heights;    ///< Of several: "geometric", "pressure"; "auto".
  const char* format;     ///< Of points: "text", "npy", "bin" (raw float64); "auto".
  const char* time_unit;  ///< Of recordings: "s", "ms", "us", "ns"; "auto".
  const char* time_zone;  ///< Of dates and times that name none: "UTC", "Europe/Madrid", "+02:00".
  const char* scale;      ///< Of positions in pixels, how long one is: "0.1mm"; NULL: none are.
  double fps;  ///< Of recordings in which a column counts frames: how many a second; 0: none does.
  const char* dates;  ///< Of dates as 05/06/2024: "day-first", "month-first"; "auto": one tells it.
  double least_likelihood;  ///< Of tables of poses (DeepLabCut, SLEAP): places less likely than
                            ///< this, of 1 at most, count as unknown; 0: than 0.6.
  double tolerance_m;  ///< Of shows: how far, in metres, straight lines may be from the curve that
                       ///< they follow; 0: 0.001.
} beespace_io_options;

/* ---- What is to be said of what was read ---------------------------------------------------- */

/// @brief What a file was taken for, and why: what the command prints before its answer. It belongs
/// to the handle that it is asked of.
typedef struct beespace_io_facts beespace_io_facts;

/// @brief Says what coordinates were taken for.
/// @param facts The facts.
/// @return "wgs84" or "metres".
BEESPACE_C_API const char* beespace_io_facts_frame(const beespace_io_facts* facts);
/// @brief Says why they were taken for that.
/// @param facts The facts.
/// @return A phrase: "the header names longitude and latitude".
BEESPACE_C_API const char* beespace_io_facts_frame_reason(const beespace_io_facts* facts);
/// @brief Says how the file is written.
/// @param facts The facts.
/// @return A phrase: "text, comma-separated, gzip-compressed".
BEESPACE_C_API const char* beespace_io_facts_format(const beespace_io_facts* facts);
/// @brief Says what heights are counted from.
/// @param facts The facts.
/// @return "above mean sea level", ...; empty where the file does not say.
BEESPACE_C_API const char* beespace_io_facts_heights(const beespace_io_facts* facts);
/// @brief Says how many sentences there are about units and about what else was decided. They must
/// be shown to people who rely on the answer.
/// @param facts The facts.
/// @return The number of notes.
BEESPACE_C_API int64_t beespace_io_facts_note_count(const beespace_io_facts* facts);
/// @brief Gives a note.
/// @param facts The facts.
/// @param index Which, from 0.
/// @return "heights in ft: the header names it: 'alt_ft'", ...; NULL where there is none.
BEESPACE_C_API const char* beespace_io_facts_note(const beespace_io_facts* facts, int64_t index);
/// @brief Says how many bad records were left out, with BEESPACE_IO_SKIP_BAD. An answer is of the
/// others: none at risk does not mean that none of these is.
/// @param facts The facts.
/// @return The number of records.
BEESPACE_C_API int64_t beespace_io_facts_skipped(const beespace_io_facts* facts);
/// @brief Gives why a record was left out, of the first 20.
/// @param facts The facts.
/// @param index Which of those that were left out, from 0.
/// @param[out] error What is wrong with it.
/// @return Its code; BEESPACE_OK where there is none of this index, or it is not kept.
BEESPACE_C_API beespace_code beespace_io_facts_skipped_error(const beespace_io_facts* facts,
                                                             int64_t index,
                                                             beespace_io_error* error);

/* ---- Points --------------------------------------------------------------------------------- */

/// @brief The points of a file: where all were at one moment.
typedef struct beespace_io_points beespace_io_points;

/// @brief Reads points from a file: a table of text, an array of NumPy (.npy) or raw doubles
/// (.bin).
///
/// A recording, in which something is at more than one place, is an error: each fix would count as
/// a point. Points have no velocities: where a table has columns of them, a note says that they are
/// left out; beespace_io_read_recording() reads them. Memory: the file, while it is read;
/// then about 40 bytes a point and its id.
///
/// @param path The file.
/// @param options How to read it; or NULL.
/// @param[out] points The points; NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_CANNOT_OPEN, BEESPACE_READ_FAILED,
///   BEESPACE_INVALID_ARGUMENT of options, and those from BEESPACE_NOT_FINITE to
///   BEESPACE_CORRUPT of what is in the file.
BEESPACE_C_API beespace_code beespace_io_read_points(const char* path,
                                                     const beespace_io_options* options,
                                                     beespace_io_points** points,
                                                     beespace_io_error* error);
/// @brief Frees points.
/// @param points The points; NULL does nothing.
BEESPACE_C_API void beespace_io_points_free(beespace_io_points* points);
/// @brief Says how many points there are.
/// @param points The points.
/// @return The number of points.
BEESPACE_C_API int64_t beespace_io_points_count(const beespace_io_points* points);
/// @brief Gives the positions: x0 y0 z0 x1 y1 z1 ... in metres, of degrees those of ECEF.
/// @param points The points.
/// @return 3 * count coordinates; NULL where there is no point.
BEESPACE_C_API const double* beespace_io_points_xyz(const beespace_io_points* points);
/// @brief Gives longitude and latitude in degrees and the height in metres of each point:
/// lon0 lat0 height0 lon1 ...
/// @param points The points.
/// @return 3 * count numbers; NULL of points that were in metres.
BEESPACE_C_API const double* beespace_io_points_degrees(const beespace_io_points* points);
/// @brief Gives the row of data that each point was in, from 0; records that were left out count.
/// @param points The points.
/// @return `count` rows, ascending; NULL where there is no point.
BEESPACE_C_API const int64_t* beespace_io_points_rows(const beespace_io_points* points);
/// @brief Gives what the file calls a point.
/// @param points The points.
/// @param index Which point, from 0.
/// @return Its id; empty where that is empty; NULL where the file has no ids, or no such point.
BEESPACE_C_API const char* beespace_io_points_id(const beespace_io_points* points, int64_t index);
/// @brief Gives all ids, one after the other, each with a zero byte at its end.
/// @param points The points.
/// @param[out] offsets Where each begins, and after the last one the size of all: count + 1
///   numbers. NULL is fine.
/// @return The texts; NULL where the file has no ids.
BEESPACE_C_API const char* beespace_io_points_ids(const beespace_io_points* points,
                                                  const int64_t** offsets);
/// @brief Gives what the file was taken for.
/// @param points The points.
/// @return The facts, which end with the points; NULL of NULL.
BEESPACE_C_API const beespace_io_facts* beespace_io_points_facts(const beespace_io_points* points);

/// @brief The points for a question of <beespace.h>. Nothing is copied.
///
/// A vertical threshold is for points in metres: z of ECEF is not a height.
///
/// @param points The points; they must outlive the structure.
/// @return The structure.
static inline beespace_points beespace_io_points_view(const beespace_io_points* points) {
  return beespace_points_interleaved(beespace_io_points_xyz(points),
                                     beespace_io_points_count(points));
}

/* ---- Recordings ----------------------------------------------------------------------------- */

/// @brief A recording: where each of many agents (bees, drones, aircraft) was when. Fixes stand in
/// columns, agent by agent, those of each in ascending order of time.
typedef struct beespace_io_recording beespace_io_recording;

/// @brief Reads a recording: a table of fixes, or many; a drone show; a telemetry log; PX4 logs;
/// reports of aircraft.
///
/// Where nothing is known, between fixes far apart in time or of records that were left out,
/// nothing is made up: no fix is interpolated. Curves of drone shows become straight lines between
/// fixes, at most 1 mm away from the curve.
///
/// @param paths Files that are read as one recording; or one folder.
/// @param path_count How many paths there are.
/// @param options How to read them; or NULL. `format` is refused here, `threads` says nothing.
/// @param[out] recording The recording; NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_io_read_points(), and
///   BEESPACE_TIME_ORDER.
BEESPACE_C_API beespace_code beespace_io_read_recording(const char* const* paths,
                                                        int64_t path_count,
                                                        const beespace_io_options* options,
                                                        beespace_io_recording** recording,
                                                        beespace_io_error* error);
/// @brief Frees a recording.
/// @param recording The recording; NULL does nothing.
BEESPACE_C_API void beespace_io_recording_free(beespace_io_recording* recording);
/// @brief Says how many agents there are.
/// @param recording The recording.
/// @return The number of agents.
BEESPACE_C_API int64_t beespace_io_recording_agents(const beespace_io_recording* recording);
/// @brief Says how many fixes there are, of all agents together.
/// @param recording The recording.
/// @return The number of fixes.
BEESPACE_C_API int64_t beespace_io_recording_fixes(const beespace_io_recording* recording);
/// @brief Gives where the fixes of each agent begin: those of agent a are offsets[a] to
/// offsets[a + 1] - 1. An agent may have none.
/// @param recording The recording.
/// @return beespace_io_recording_agents() + 1 offsets; NULL of NULL.
BEESPACE_C_API const int64_t* beespace_io_recording_offsets(const beespace_io_recording* recording);
/// @brief Gives whose each fix is: the index of the agent.
/// @param recording The recording.
/// @return beespace_io_recording_fixes() indices; NULL where there is no fix.
BEESPACE_C_API const int64_t* beespace_io_recording_agent(const beespace_io_recording* recording);
/// @brief Gives the time of each fix in seconds: since 1970 in UTC, or from a zero of the file's.
/// @param recording The recording.
/// @return beespace_io_recording_fixes() times; NULL where there is no fix.
BEESPACE_C_API const double* beespace_io_recording_times_s(const beespace_io_recording* recording);
/// @brief Gives the position of each fix: x0 y0 z0 x1 ... in metres, of degrees those of ECEF.
/// @param recording The recording.
/// @return 3 * beespace_io_recording_fixes() coordinates; NULL where there is no fix.
BEESPACE_C_API const double* beespace_io_recording_xyz(const beespace_io_recording* recording);
/// @brief Gives the velocity of each fix: vx0 vy0 vz0 vx1 ... in metres per second, along the axes
/// of the positions: of degrees those of ECEF, whatever the file has (east, north and up; speed,
/// track and climb rate).
///
/// Of a fix whose velocity is not known as a whole, all three are not-a-number: its fields are
/// empty, how fast it climbs is not known, or its input has none. A note says of how many that is
/// so. Nothing is made up: none is taken from positions.
///
/// @param recording The recording.
/// @return 3 * beespace_io_recording_fixes() numbers; NULL where no fix has a velocity.
BEESPACE_C_API const double* beespace_io_recording_velocities(
    const beespace_io_recording* recording);
/// @brief Gives longitude and latitude in degrees and the height in metres of each fix.
/// @param recording The recording.
/// @return 3 * beespace_io_recording_fixes() numbers; NULL of recordings in metres.
BEESPACE_C_API const double* beespace_io_recording_degrees(const beespace_io_recording* recording);
/// @brief Gives what the input calls an agent.
/// @param recording The recording.
/// @param agent Its index, from 0.
/// @return Its id; NULL where there is no such agent.
BEESPACE_C_API const char* beespace_io_recording_id(const beespace_io_recording* recording,
                                                    int64_t agent);
/// @brief Gives all ids, one after the other, each with a zero byte at its end.
/// @param recording The recording.
/// @param[out] offsets Where each begins, and after the last one the size of all. NULL is fine.
/// @return The texts; NULL of NULL.
BEESPACE_C_API const char* beespace_io_recording_ids(const beespace_io_recording* recording,
                                                     const int64_t** offsets);
/// @brief Gives what an agent is called beside its id, as the flight of an aircraft.
/// @param recording The recording.
/// @param agent Its index, from 0.
/// @return The label, or an empty text; NULL where there is no such agent.
BEESPACE_C_API const char* beespace_io_recording_label(const beespace_io_recording* recording,
                                                       int64_t agent);
/// @brief Says whether times are seconds since 1970 (UTC).
/// @param recording The recording.
/// @return 1 if they are; 0 if they have a zero of their own.
BEESPACE_C_API int32_t beespace_io_recording_since_1970(const beespace_io_recording* recording);
/// @brief Says whether it is a drone show: a plan, which has no gaps.
/// @param recording The recording.
/// @return 1 if it is; 0 if not.
BEESPACE_C_API int32_t beespace_io_recording_is_show(const beespace_io_recording* recording);
/// @brief Says how many records are left out since their place, height or time is missing or bad,
/// skipped ones among them. An answer is of the others: no conflict does not mean that there is
/// none with these.
/// @param recording The recording.
/// @return The number of records.
BEESPACE_C_API int64_t beespace_io_recording_missing(const beespace_io_recording* recording);
/// @brief How it is known how fast an agent flies: what beespace_io_recording_movers() writes.
enum {
  BEESPACE_IO_NOWHERE = 0,           ///< It has no fix: nothing is known of it.
  BEESPACE_IO_STALE = 1,             ///< It was last heard of too long ago, or on the ground.
  BEESPACE_IO_WITHOUT_VELOCITY = 2,  ///< Neither a velocity nor fixes that tell it.
  BEESPACE_IO_ESTIMATED = 3,         ///< The velocity, or a part of it, is that of its last fixes.
  BEESPACE_IO_STATED = 4             ///< The velocity is that of its last fix.
};
/// @brief Says where all agents are at the last time of a recording, and how fast they fly: for
/// beespace_predict(), as the command `beespace predict` reads it.
///
/// An agent that was last heard of before is brought to that time in a straight line. Of one that
/// is stale or without a velocity it is not known where it goes: it has the place where it was last
/// heard of, and a velocity of not-a-numbers, which beespace_predict() refuses. Who leaves such
/// agents out must say so: no conflict of the others does not mean that there is none with these.
///
/// @param recording The recording.
/// @param max_age_s Agents that were last heard of longer ago than this, in seconds, are stale; and
///   two fixes farther apart tell no velocity. The command takes 30.
/// @param[out] xyz Where: 3 * beespace_io_recording_agents() coordinates, as those of
///   beespace_io_recording_xyz(); not-a-numbers where the agent has no fix.
/// @param[out] velocities How fast: as many numbers, as those of
/// beespace_io_recording_velocities().
/// @param[out] known BEESPACE_IO_STATED ... of each agent; or NULL.
/// @param[out] time_s The last time of the recording, in seconds; or NULL.
/// @param[out] error What went wrong; or NULL. What was written of the arrays is then of no use.
/// @return BEESPACE_OK or the code of the error: BEESPACE_INVALID_ARGUMENT; BEESPACE_MISSING_COLUMN
///   where it is known of no agent how fast it flies; BEESPACE_UNSUPPORTED_FORMAT of drone shows,
///   whose curves say where each is.
BEESPACE_C_API beespace_code beespace_io_recording_movers(const beespace_io_recording* recording,
                                                          double max_age_s, double* xyz,
                                                          double* velocities, uint8_t* known,
                                                          double* time_s, beespace_io_error* error);
/// @brief Gives what the input was taken for.
/// @param recording The recording.
/// @return The facts, which end with the recording; NULL of NULL.
BEESPACE_C_API const beespace_io_facts* beespace_io_recording_facts(
    const beespace_io_recording* recording);

/* ---- What is known of a recording ----------------------------------------------------------- */

/// @brief Of how much of a recording it is known where its agents were: what an answer about it is
/// about. An agent is unknown in gaps between fixes, before its first and after its last one, and
/// in records that are left out.
typedef struct beespace_io_coverage {
  size_t struct_size;         ///< sizeof(beespace_io_coverage), set by the caller.
  int32_t complete;           ///< 1 where it is known all the time where all agents were.
  int32_t may_hide;           ///< 1 where an agent was there, but it is not known where: that no
                              ///< conflict was found is no all-clear.
  double max_gap_s;           ///< Fixes farther apart in time were taken for a gap; infinite: none.
  double typical_interval_s;  ///< The interval that this comes from; NaN where it was given.
  int64_t gaps;               ///< How many gaps there are.
  int64_t agents_with_gaps;   ///< How many agents have one.
  double in_gaps_s;           ///< How long they are, summed over the agents.
  int64_t agents_partly;   ///< Of how many agents the first fix is later, or the last one earlier,
                           ///< than those of others.
  int64_t agents_cut_off;  ///< Of these: in the air then.
  double outside_s;        ///< How long that is, summed over the agents.
  int64_t missing;         ///< As beespace_io_recording_missing().
  int64_t missing_without_id;  ///< Of these: records of which it is not known whose they are.
  int64_t missing_agents;      ///< Of how many agents the others are.
  int64_t nowhere;             ///< How many of these agents have no known place at all.
  int64_t shared_ids;  ///< How many ids seem to be of two agents each: at two places in turn.
  int64_t files;       ///< How many files and folders beside those that were read were left out.
  int64_t jumping;     ///< How many agents jump faster than anything flies, or than they say.
  int64_t swapped;  ///< Of how many agents longitude and latitude seem to be the other way round.
  int64_t agents_unplaced;  ///< Of agents_partly: there then, in records without a place.
  int64_t untimed;          ///< Of how many agents it is not known when they were where they say.
  int64_t rough;  ///< How many agents have places too rough: by Argos, or of too few decimals.
  int64_t agents_on_ground;  ///< Of agents_partly: on the ground by all their records, which do not
                             ///< reach as far as others fly.
  int64_t agents_alone;      ///< How many drones fly while no other is known: compared with none.
} beespace_io_coverage;

/// @brief Says of how much of a recording it is known where its agents were: `known` of `beespace
/// replay --json`.
/// @param recording The recording.
/// @param max_gap_s As beespace_io_page_options::max_gap_s. Shows have no gaps.
/// @param[out] coverage What is known.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_io_recording_coverage(const beespace_io_recording* recording,
                                                            double max_gap_s,
                                                            beespace_io_coverage* coverage,
                                                            beespace_io_error* error);
/// @brief Writes what is not known in one line: "1 bee unknown for 8 s in all, 3 records were left
/// out"; nothing where all is.
/// @param coverage The coverage.
/// @param[out] text Where to; ends with a zero byte, where `size` is not 0.
/// @param size How many bytes there are.
/// @return How many bytes the whole line has, without the zero: `size` or more where it was cut.
BEESPACE_C_API size_t beespace_io_coverage_text(const beespace_io_coverage* coverage, char* text,
                                                size_t size);

/* ---- Conflicts of a recording --------------------------------------------------------------- */

/// @brief The flags of beespace_io_conflict_options::flags, beside BEESPACE_INCLUSIVE.
enum {
  BEESPACE_IO_ALONG_LINES = 2  ///< Agents fly in straight lines between fixes, whatever velocities
                               ///< they have.
};

/// @brief What a search for conflicts needs to know; NULL is as good as one of zeros.
typedef struct beespace_io_conflict_options {
  size_t struct_size;    ///< sizeof(beespace_io_conflict_options)
  uint32_t flags;        ///< BEESPACE_INCLUSIVE | BEESPACE_IO_ALONG_LINES, or 0.
  uint32_t limited;      ///< 1: `max_results` counts; 0: there may be any number of conflicts.
  uint64_t reserved;     ///< Zero.
  double threshold_m;    ///< The threshold in metres; 0: what the recording declares, else 2 m of a
                         ///< show. Other recordings have no default.
  double max_gap_s;      ///< As beespace_io_page_options::max_gap_s. Shows have no gaps.
  const char* vertical;  ///< A vertical threshold, in metres or with its unit: "50", "1000ft"; or
                         ///< NULL. Heights of degrees are compared with it as the file has them.
  uint64_t max_results;  ///< More conflicts than this are an error, where `limited` says so.
  const beespace_run* run;  ///< Threads, and what ends the call early; or NULL.
  double ignore_below_m;    ///< Conflicts of two that are both lower than this, in metres, above
                            ///< where they took off are left out, and counted; 0: none is. Also of
                            ///< a struct_size without this field.
} beespace_io_conflict_options;

/// @brief The conflicts of a recording.
typedef struct beespace_io_conflicts beespace_io_conflicts;

/// @brief Which agents of a recording came closer than a threshold, and when? What `beespace
/// replay` says: along straight lines from fix to fix; along the curves of a show, also with drones
/// that stand on the ground; and, as possible ones, along curves with the velocities of the fixes,
/// and along the arcs on which aircraft turn between them.
/// @param recording The recording.
/// @param options What the search needs to know; or NULL.
/// @param[out] conflicts The conflicts, to be freed by beespace_io_conflicts_free(); NULL after an
///   error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_INVALID_ARGUMENT;
///   BEESPACE_INVALID_THRESHOLD, also where there is none; BEESPACE_TOO_MANY_RESULTS;
///   BEESPACE_OUTSIDE_DOMAIN; BEESPACE_STOPPED.
BEESPACE_C_API beespace_code beespace_io_find_conflicts(const beespace_io_recording* recording,
                                                        const beespace_io_conflict_options* options,
                                                        beespace_io_conflicts** conflicts,
                                                        beespace_io_error* error);
/// @brief Frees conflicts.
/// @param conflicts The conflicts; NULL does nothing.
BEESPACE_C_API void beespace_io_conflicts_free(beespace_io_conflicts* conflicts);

/// @brief What was found, in numbers.
typedef struct beespace_io_conflict_facts {
  size_t struct_size;  ///< sizeof(beespace_io_conflict_facts), set by the caller.
  int32_t risky;       ///< 0 is an all-clear; 1 where there is a conflict, one may be hidden, or
                       ///< nothing could be compared: with which `replay --fail-on-risk` ends.
  int32_t compared;    ///< 0 where no two agents are there at the same time.
  int32_t velocities;  ///< 1 where velocities were looked at; 0 where there are none, or they do
                       ///< not count.
  int32_t too_far;     ///< 1 where velocities lead too far away from straight lines to be followed:
                       ///< they may hide a conflict.
  double most_off_m;   ///< How far, in metres, curves with the velocities leave the straight lines
                       ///< at most.
  double threshold_m;  ///< The threshold that was taken, in metres.
  int64_t with_standing;  ///< How many conflicts are with a drone on the ground.
  int64_t possible;       ///< How many are possible, not certain.
  int64_t closest_first;  ///< One of the closest two, in conflict or not; with a vertical threshold
                          ///< those of a conflict; -1 where there are none.
  int64_t closest_second;  ///< The other.
  double closest_m;        ///< How close they come in a straight line, in metres; NaN for none.
  double closest_s;        ///< When, in seconds; NaN for none.
  int64_t ignored;         ///< How many conflicts ignore_below_m leaves out; the closest two may be
                           ///< of one of them.
  int64_t takeoff_unknown;  ///< With it: of how many agents it is not known where they took off;
                            ///< none of their conflicts is left out.
} beespace_io_conflict_facts;

/// @brief Says what was found, in numbers.
/// @param conflicts The conflicts.
/// @param[out] facts The numbers.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_io_conflicts_facts_of(const beespace_io_conflicts* conflicts,
                                                            beespace_io_conflict_facts* facts,
                                                            beespace_io_error* error);
/// @brief Says what the answer is about: of how much it is known where agents were.
/// @param conflicts The conflicts.
/// @param[out] coverage What is known.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_io_conflicts_coverage(const beespace_io_conflicts* conflicts,
                                                            beespace_io_coverage* coverage,
                                                            beespace_io_error* error);
/// @brief Says how many conflicts there are, in ascending order of the first agent, the second one,
/// and when they begin: as the rows of `beespace replay`.
/// @param conflicts The conflicts.
/// @return Their number; 0 of NULL.
BEESPACE_C_API int64_t beespace_io_conflicts_size(const beespace_io_conflicts* conflicts);
/// @brief Gives the agent of the smaller index of each conflict.
/// @param conflicts The conflicts.
/// @return The indices; NULL where there is none.
BEESPACE_C_API const int64_t* beespace_io_conflicts_first(const beespace_io_conflicts* conflicts);
/// @brief Gives the other agent of each conflict.
/// @param conflicts The conflicts.
/// @return The indices; NULL where there is none.
BEESPACE_C_API const int64_t* beespace_io_conflicts_second(const beespace_io_conflicts* conflicts);
/// @brief Gives when each conflict begins, in seconds.
/// @param conflicts The conflicts.
/// @return The times; NULL where there is none.
BEESPACE_C_API const double* beespace_io_conflicts_begins_s(const beespace_io_conflicts* conflicts);
/// @brief Gives when each conflict ends, in seconds.
/// @param conflicts The conflicts.
/// @return The times; NULL where there is none.
BEESPACE_C_API const double* beespace_io_conflicts_ends_s(const beespace_io_conflicts* conflicts);
/// @brief Gives when both are closest, in seconds.
/// @param conflicts The conflicts.
/// @return The times; NULL where there is none.
BEESPACE_C_API const double* beespace_io_conflicts_closest_s(
    const beespace_io_conflicts* conflicts);
/// @brief Gives how close they are then in a straight line, in metres.
/// @param conflicts The conflicts.
/// @return The distances; NULL where there is none.
BEESPACE_C_API const double* beespace_io_conflicts_closest_m(
    const beespace_io_conflicts* conflicts);
/// @brief Says which conflicts are certain: 1; others are possible only: 0.
/// @param conflicts The conflicts.
/// @return A byte each; NULL where there is none.
BEESPACE_C_API const uint8_t* beespace_io_conflicts_certain(const beespace_io_conflicts* conflicts);
/// @brief Says in how many gaps between fixes it is unknown where an agent was.
/// @param conflicts The conflicts.
/// @return Their number; 0 of NULL.
BEESPACE_C_API int64_t beespace_io_conflicts_gaps(const beespace_io_conflicts* conflicts);
/// @brief Gives the agent of each gap, ascending.
/// @param conflicts The conflicts.
/// @return The indices; NULL where there is none.
BEESPACE_C_API const int64_t* beespace_io_conflicts_gap_agent(
    const beespace_io_conflicts* conflicts);
/// @brief Gives the time of the fix before each gap, in seconds.
/// @param conflicts The conflicts.
/// @return The times; NULL where there is none.
BEESPACE_C_API const double* beespace_io_conflicts_gap_begins_s(
    const beespace_io_conflicts* conflicts);
/// @brief Gives the time of the fix after each gap, in seconds.
/// @param conflicts The conflicts.
/// @return The times; NULL where there is none.
BEESPACE_C_API const double* beespace_io_conflicts_gap_ends_s(
    const beespace_io_conflicts* conflicts);

/* ---- Obstacles ------------------------------------------------------------------------------ */

/// @brief The obstacles of a file.
typedef struct beespace_io_obstacles beespace_io_obstacles;

/// @brief Reads obstacles from a file: JSON, as `beespace advise --obstacles` reads it.
/// @param path The file.
/// @param[out] obstacles The obstacles; NULL after an error.
/// @param[out] error What went wrong, and with which obstacle; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_io_read_points().
BEESPACE_C_API beespace_code beespace_io_read_obstacles(const char* path,
                                                        beespace_io_obstacles** obstacles,
                                                        beespace_io_error* error);
/// @brief Frees obstacles.
/// @param obstacles The obstacles; NULL does nothing.
BEESPACE_C_API void beespace_io_obstacles_free(beespace_io_obstacles* obstacles);
/// @brief Says how many obstacles there are.
/// @param obstacles The obstacles.
/// @return Their number; 0 of NULL.
BEESPACE_C_API int64_t beespace_io_obstacles_count(const beespace_io_obstacles* obstacles);
/// @brief Gives the obstacles, for beespace_obstacles_create(), which copies them.
/// @param obstacles The obstacles.
/// @return beespace_io_obstacles_count() of them; NULL where there is none.
BEESPACE_C_API const beespace_obstacle* beespace_io_obstacles_list(
    const beespace_io_obstacles* obstacles);

/* ---- Verification --------------------------------------------------------------------------- */

/// @brief What a flight may have limits of, and what was found of it: the index of
/// beespace_io_verify_options::most and the kind of a finding. Kinds are named as the command names
/// them: beespace_io_finding_name().
enum {
  BEESPACE_IO_SPEED = 0,         ///< The speed, in metres per second.
  BEESPACE_IO_HORIZONTAL = 1,    ///< The speed in x and y, in metres per second.
  BEESPACE_IO_CLIMB = 2,         ///< The speed upwards, in metres per second.
  BEESPACE_IO_DESCENT = 3,       ///< The speed downwards, in metres per second.
  BEESPACE_IO_ACCELERATION = 4,  ///< The acceleration, in metres per second squared. Where a path
                                 ///< turns at a point: what turns within half of the pieces beside
                                 ///< it, and within 0.5 m of the path.
  BEESPACE_IO_HEIGHT = 5,        ///< z, in metres.
  BEESPACE_IO_LOSS = 6,          ///< Two agents closer than the threshold. No limit.
  BEESPACE_IO_CLEARANCE = 7      ///< An agent closer to an obstacle than the clearance. No limit.
};

/// @brief The flags of beespace_io_verify_options::flags.
enum {
  BEESPACE_IO_STRAIGHT = 1  ///< Agents fly in straight lines between fixes, whatever velocities
                            ///< they have. Drones of a show, which has curves, do not.
};

/// @brief What a verification needs to know; NULL is as good as one of zeros.
typedef struct beespace_io_verify_options {
  size_t struct_size;  ///< sizeof(beespace_io_verify_options)
  uint32_t flags;      ///< BEESPACE_IO_STRAIGHT, or 0.
  uint32_t limits;     ///< 1 << BEESPACE_IO_SPEED | ...: which of `most` are given. Of the others
                       ///< those count that a show declares.
  uint64_t reserved;   ///< Zero.
  double most[6];      ///< The greatest values, by BEESPACE_IO_SPEED, ...; zero where not given.
  double threshold_m;  ///< The threshold in metres; 0: what the recording declares, else 2 m of a
                       ///< show. Other recordings have no default.
  double max_gap_s;    ///< As beespace_io_page_options::max_gap_s. Shows have no gaps.
  const beespace_obstacle* obstacles;  ///< Static obstacles; or NULL. They are copied.
  int64_t obstacle_count;              ///< How many.
  double clearance_m;          ///< With obstacles: how close to one is too close, in metres.
  const beespace_run* run;     ///< Threads, and what ends the call early; or NULL.
  const char* skipped_limits;  ///< Names, joined by commas, of limits that the show declares and
                               ///< that need not be looked at where that is not done, as
                               ///< "minNavAltitude": beespace_io_verdict_not_looked_at(). Or NULL.
                               ///< A struct_size without this field is taken, too.
  double ignore_below_m;       ///< As beespace_io_conflict_options::ignore_below_m, of losses.
} beespace_io_verify_options;

/// @brief What a verification found.
typedef struct beespace_io_verdict beespace_io_verdict;

/// @brief Did the agents of a recording keep apart, clear of obstacles and within their limits,
/// each with times of its own? As `beespace verify` of a show: along its curves themselves, and not
/// along beespace_io_recording_xyz(). Of other recordings along the curves that have the velocities
/// of their fixes, or in straight lines where not all fixes have one. Recordings in degrees, as
/// logs of drones, are verified in straight lines, and along curves with the velocities that there
/// are.
/// @param recording The recording. In metres each agent has a curve, or two fixes or more; in
///   degrees some has.
/// @param options What it needs to know; or NULL.
/// @param[out] verdict What was found, to be freed by beespace_io_verdict_free(); NULL after an
///   error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_INVALID_ARGUMENT;
///   BEESPACE_INVALID_THRESHOLD, also where there is none; BEESPACE_UNKNOWN_FRAME of obstacles
///   beside degrees; BEESPACE_MISSING_COLUMN where an acceleration is limited and velocities are
///   missing; BEESPACE_UNSUPPORTED_FORMAT of an agent with a single fix; BEESPACE_STOPPED. A
///   skipped limit that the show does not declare is BEESPACE_INVALID_ARGUMENT, as it may be
///   mistyped.
BEESPACE_C_API beespace_code beespace_io_verify(const beespace_io_recording* recording,
                                                const beespace_io_verify_options* options,
                                                beespace_io_verdict** verdict,
                                                beespace_io_error* error);
/// @brief Frees a verdict.
/// @param verdict The verdict; NULL does nothing.
BEESPACE_C_API void beespace_io_verdict_free(beespace_io_verdict* verdict);

/// @brief How agents flew between fixes: beespace_io_verdict_facts::motion.
enum {
  BEESPACE_IO_ALONG_SHOW = 0,        ///< Along the curves of the show.
  BEESPACE_IO_WITH_VELOCITIES = 1,   ///< Along curves with the velocities of both fixes.
  BEESPACE_IO_IN_STRAIGHT_LINES = 2  ///< In straight lines.
};

/// @brief What was found, in numbers.
typedef struct beespace_io_verdict_facts {
  size_t struct_size;    ///< sizeof(beespace_io_verdict_facts), set by the caller.
  int32_t holds;         ///< 1 where nothing was found, nothing of the flight may hide it, which
                         ///< beespace_io_verdict_coverage() says, some two were compared (or an
                         ///< agent alone with limits or obstacles), and no limit that the show
                         ///< declares is not looked at, as minNavAltitude is not where a drone
                         ///< moves sideways below it. Accelerations in one direction that a show
                         ///< declares (maxAccelerationXY) are checked, and breaches of them are of
                         ///< BEESPACE_IO_ACCELERATION.
  int32_t motion;        ///< BEESPACE_IO_ALONG_SHOW, ...
  uint32_t limits;       ///< 1 << BEESPACE_IO_SPEED | ...: which limits were checked.
  uint32_t declared;     ///< Those of them that the show declares.
  double most[6];        ///< The limits; infinite where there is none.
  double greatest[6];    ///< The greatest values: never less than they are, and a billionth more at
                         ///< most. Of climb and descent zero or more.
  double greatest_s[6];  ///< When each is reached, in seconds.
  int64_t greatest_agent[6];  ///< By whom; -1 where there is no agent.
  double threshold_m;         ///< The threshold that was taken, in metres.
  double max_gap_s;           ///< Fixes farther apart in time were taken for a gap; infinite: none.
  int64_t losses;             ///< How many findings are BEESPACE_IO_LOSS.
  int64_t clearance_losses;   ///< How many are BEESPACE_IO_CLEARANCE.
  int64_t breaches;           ///< How many are of limits.
  int64_t gaps;               ///< In how many gaps it is unknown where an agent was.
  int64_t missing;            ///< As beespace_io_recording_missing().
  int64_t closest_first;      ///< One of the closest two; -1 where no two are there at one time.
  int64_t closest_second;     ///< The other.
  double closest_m;           ///< How close they come, in metres; NaN where no two are there.
  double closest_s;           ///< When, in seconds; NaN where no two are there.
  int64_t ignored;            ///< How many losses ignore_below_m leaves out.
  int64_t takeoff_unknown;    ///< As beespace_io_conflict_facts::takeoff_unknown.
} beespace_io_verdict_facts;

/// @brief Says what was found, in numbers.
/// @param verdict The verdict.
/// @param[out] facts The numbers.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_io_verdict_facts_of(const beespace_io_verdict* verdict,
                                                          beespace_io_verdict_facts* facts,
                                                          beespace_io_error* error);
/// @brief Says what the verdict is about: of how much it is known where agents were.
/// @param verdict The verdict.
/// @param[out] coverage What is known.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_io_verdict_coverage(const beespace_io_verdict* verdict,
                                                          beespace_io_coverage* coverage,
                                                          beespace_io_error* error);
/// @brief Names the limits that the show declares and that were not looked at, joined by commas.
/// Those that are not among beespace_io_verify_options::skipped_limits keep the verdict from
/// holding.
/// @param verdict The verdict.
/// @return The names, valid as long as the verdict; "" where there is none, and of NULL.
BEESPACE_C_API const char* beespace_io_verdict_not_looked_at(const beespace_io_verdict* verdict);
/// @brief Says how many findings there are: losses, losses of clearance, and breaches by limit, in
/// this order, as the rows of `beespace verify`.
/// @param verdict The verdict.
/// @return Their number; 0 of NULL.
BEESPACE_C_API int64_t beespace_io_verdict_size(const beespace_io_verdict* verdict);
/// @brief Gives what was found: BEESPACE_IO_LOSS, ...
/// @param verdict The verdict.
/// @return The kinds; NULL where there is none.
BEESPACE_C_API const int32_t* beespace_io_verdict_kinds(const beespace_io_verdict* verdict);
/// @brief Gives the agent of each finding; of a loss the one of the smaller index.
/// @param verdict The verdict.
/// @return The indices; NULL where there is none.
BEESPACE_C_API const int64_t* beespace_io_verdict_first(const beespace_io_verdict* verdict);
/// @brief Gives, of a loss, the other agent; of clearance, the obstacle.
/// @param verdict The verdict.
/// @return The indices, -1 of other findings; NULL where there is none.
BEESPACE_C_API const int64_t* beespace_io_verdict_second(const beespace_io_verdict* verdict);
/// @brief Gives when each finding begins, in seconds.
/// @param verdict The verdict.
/// @return The times; NULL where there is none.
BEESPACE_C_API const double* beespace_io_verdict_begins_s(const beespace_io_verdict* verdict);
/// @brief Gives when each finding ends, in seconds.
/// @param verdict The verdict.
/// @return The times; NULL where there is none.
BEESPACE_C_API const double* beespace_io_verdict_ends_s(const beespace_io_verdict* verdict);
/// @brief Gives how close they came, in metres; or the greatest value of a breach.
/// @param verdict The verdict.
/// @return The values; NULL where there is none.
BEESPACE_C_API const double* beespace_io_verdict_values(const beespace_io_verdict* verdict);
/// @brief Gives when that was, in seconds.
/// @param verdict The verdict.
/// @return The times, NaN of clearance; NULL where there is none.
BEESPACE_C_API const double* beespace_io_verdict_at_s(const beespace_io_verdict* verdict);
/// @brief Names a kind of finding, or a limit, as the command does: "loss", "horizontal", ...
/// @param kind BEESPACE_IO_LOSS, ...
/// @return Its name; "unknown" for a number that is no kind. Valid for ever.
BEESPACE_C_API const char* beespace_io_finding_name(int32_t kind);

/* ---- Pages ---------------------------------------------------------------------------------- */

/// @brief What a page shows. There is no default for the threshold. Texts may be NULL.
typedef struct beespace_io_page_options {
  size_t struct_size;  ///< sizeof(beespace_io_page_options)
  uint32_t flags;      ///< BEESPACE_INCLUSIVE, or 0.
  uint32_t threads;    ///< How many threads may search; 0 is 1, or BEESPACE_ALL_PROCESSORS.
  uint64_t reserved;   ///< Zero.
  double threshold_m;  ///< The threshold in metres, above zero.
  double max_gap_s;  ///< Of recordings: between fixes farther apart in time nothing is known. 0 is
                     ///< five times the typical interval, infinity joins all fixes.
  const char* vertical;     ///< A vertical threshold, in metres or with its unit: "50", "1000ft".
  const char* title;        ///< What the page is called; NULL for the name of the file.
  const beespace_run* run;  ///< Who may end the search, with BEESPACE_STOPPED: by its stop, or its
                            ///< poll. Its threads say nothing; or NULL.
  double ignore_below_m;    ///< As beespace_io_conflict_options::ignore_below_m; of recordings.
} beespace_io_page_options;

/// @brief A page about points or a recording: one file of HTML that opens without a network, in
/// three dimensions, with the worst pairs and, of recordings, the time. It is what `beespace
/// report` writes.
typedef struct beespace_io_page beespace_io_page;

/// @brief Makes a page about what is in files: points or a recording, whichever they hold.
/// @param paths One file; or files or a folder that are one recording.
/// @param path_count How many paths there are.
/// @param options How to read them; or NULL. `format` is refused here, `threads` says nothing.
/// @param page_options What to show.
/// @param[out] page The page; NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_io_read_points() and
///   beespace_io_read_recording(); BEESPACE_INVALID_THRESHOLD; BEESPACE_STOPPED;
///   BEESPACE_INVALID_ARGUMENT also where this build has no pages (BEESPACE_WEB=OFF).
BEESPACE_C_API beespace_code beespace_io_page_of_files(const char* const* paths, int64_t path_count,
                                                       const beespace_io_options* options,
                                                       const beespace_io_page_options* page_options,
                                                       beespace_io_page** page,
                                                       beespace_io_error* error);
/// @brief Makes a page about points that were read.
/// @param points The points. A vertical threshold is for those in metres.
/// @param page_options What to show.
/// @param[out] page The page; NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_io_page_of_files().
BEESPACE_C_API beespace_code beespace_io_page_of_read(const beespace_io_points* points,
                                                      const beespace_io_page_options* page_options,
                                                      beespace_io_page** page,
                                                      beespace_io_error* error);
/// @brief Makes a page about points in memory.
/// @param points The points, in metres; z is up.
/// @param ids What each point is called; or NULL, for their indices.
/// @param page_options What to show.
/// @param[out] page The page; NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_at_risk(), and
///   BEESPACE_INVALID_ARGUMENT where this build has no pages.
BEESPACE_C_API beespace_code
beespace_io_page_of_points(const beespace_points* points, const char* const* ids,
                           const beespace_io_page_options* page_options, beespace_io_page** page,
                           beespace_io_error* error);
/// @brief Frees a page.
/// @param page The page; NULL does nothing.
BEESPACE_C_API void beespace_io_page_free(beespace_io_page* page);
/// @brief Gives the page as text.
/// @param page The page.
/// @param[out] size How many bytes it has, without the zero at the end; NULL is fine.
/// @return HTML in UTF-8; empty of NULL.
BEESPACE_C_API const char* beespace_io_page_html(const beespace_io_page* page, size_t* size);
/// @brief Writes the page into a file, which is there whole or not at all.
/// @param page The page.
/// @param path The file; one that is there is replaced, but not one that the page was read from.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK, BEESPACE_WRITE_FAILED or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_io_page_write(const beespace_io_page* page, const char* path,
                                                    beespace_io_error* error);
/// @brief Says whether the page shows a danger: points at risk, conflicts, or gaps that may hide
/// one.
/// @param page The page.
/// @return 1 if it does; 0 if what is known is not at risk.
BEESPACE_C_API int32_t beespace_io_page_risky(const beespace_io_page* page);
/// @brief Says how many sentences the page has about how the input was read and what is left out.
/// @param page The page.
/// @return The number of notes.
BEESPACE_C_API int64_t beespace_io_page_note_count(const beespace_io_page* page);
/// @brief Gives a note.
/// @param page The page.
/// @param index Which, from 0.
/// @return The note; NULL where there is none.
BEESPACE_C_API const char* beespace_io_page_note(const beespace_io_page* page, int64_t index);

#ifdef __cplusplus
}
#endif

#endif
