/// @file
/// @brief Did agents keep apart, clear of obstacles and within their limits? Part of <beespace.h>.
///
/// Between two times at which all agents are known, all of the time is looked at, not samples of
/// it. The check shares no code with what gives advice.
#ifndef BEESPACE_C_VERIFY_H
#define BEESPACE_C_VERIFY_H

#include <beespace/c/basics.h>
#include <beespace/c/obstacles.h>
#include <beespace/c/recording.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief The flags of beespace_verify_options::flags. A value whose flag is not set must be zero.
enum beespace_verify_flags {
  BEESPACE_VERIFY_MAX_SPEED = 1,         ///< `max_speed_mps` is to be kept.
  BEESPACE_VERIFY_MAX_ACCELERATION = 2,  ///< `max_acceleration_mps2` is to be kept.
  BEESPACE_VERIFY_STRAIGHT = 4  ///< Agents fly in straight lines from one time to the next;
                                ///< velocities are not read, accelerations unknown.
};

/// @brief What a verification needs to know.
typedef struct beespace_verify_options {
  size_t struct_size;  ///< sizeof(beespace_verify_options)
  uint32_t flags;      ///< BEESPACE_VERIFY_MAX_SPEED | ...
  uint32_t reserved;   ///< Zero.
  double threshold_m;  ///< The threshold in metres, above zero. There is no default. What rounding
                       ///< cannot exclude counts as lost, so exactly the threshold may.
  const beespace_obstacles* obstacles;  ///< Static obstacles; kept. Or NULL.
  double clearance_m;            ///< With obstacles: how close to one is too close, in metres.
  double max_speed_mps;          ///< The greatest speed, in metres per second.
  double max_acceleration_mps2;  ///< The greatest acceleration, in metres per second squared.
} beespace_verify_options;

/// @brief A check, step after step, in memory of its own. It serves one call at a time.
typedef struct beespace_verifier beespace_verifier;

/// @brief Makes a verifier that has checked nothing.
/// @param options What it needs to know.
/// @param[out] verifier The verifier, to be freed by beespace_verifier_free(); NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_INVALID_THRESHOLD,
///   BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_verifier_create(const beespace_verify_options* options,
                                                      beespace_verifier** verifier,
                                                      beespace_error* error);
/// @brief Frees a verifier.
/// @param verifier The verifier; NULL does nothing.
BEESPACE_C_API void beespace_verifier_free(beespace_verifier* verifier);

/// @brief Takes where all agents are at a time, and how fast: the end of the step that the call
/// before began.
///
/// In a step an agent flies on the cubic curve that has its positions and velocities at both ends:
/// where it accelerates evenly, that is how it flies.
///
/// @param verifier The verifier.
/// @param time_s The time in seconds; after that of the call before.
/// @param positions Where the agents are, in metres; as many each time, in the same order.
/// @param velocities Their velocities, in metres per second. With BEESPACE_VERIFY_STRAIGHT they are
///   not read, and may be NULL.
/// @param run Threads, and what ends the call early; or NULL. After BEESPACE_STOPPED,
///   beespace_verdict::moments says whether the time was taken: where it was not, the same call can
///   be made again.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error; the verifier is then as before:
///   - BEESPACE_TIME_ORDER: a time that is not after the one before;
///   - BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN: a value that is not of the motion domain, as
///     beespace_closest_approach() says, with the agent in beespace_error::record;
///   - BEESPACE_INVALID_ARGUMENT: another number of agents;
///   - BEESPACE_STOPPED, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_verifier_add(beespace_verifier* verifier, double time_s,
                                                   const beespace_points* positions,
                                                   const beespace_points* velocities,
                                                   const beespace_run* run, beespace_error* error);
/// @brief Takes a recording whose agents all have fixes at the same times, one time after the
/// other: as beespace_verifier_add() of each, with the agents in ascending order of their ids.
/// @param verifier The verifier, of straight lines (BEESPACE_VERIFY_STRAIGHT).
/// @param recording The recording, without heights apart.
/// @param max_gap_s The longest step in seconds that was seen; above zero, INFINITY for all. What
/// is
///   longer is skipped.
/// @param run As of beespace_verifier_add().
/// @param[out] error What went wrong; or NULL. beespace_error::record is that of an agent.
/// @return BEESPACE_OK or the code of the error: as beespace_verifier_add(); and
///   BEESPACE_INVALID_ARGUMENT, of the agent that lacks a fix which the first one has, or has one
///   more. After an error, beespace_verdict::moments says how many times were taken.
BEESPACE_C_API beespace_code beespace_verifier_add_recording(beespace_verifier* verifier,
                                                             const beespace_recording* recording,
                                                             double max_gap_s,
                                                             const beespace_run* run,
                                                             beespace_error* error);
/// @brief Says that it was not seen what agents did from the last time on until the next one: no
/// step is checked in between, and the verdict does not hold. There may be other agents then.
/// @param verifier The verifier; NULL does nothing.
BEESPACE_C_API void beespace_verifier_skip(beespace_verifier* verifier);

/// @brief What was found so far.
typedef struct beespace_verdict {
  size_t struct_size;         ///< sizeof(beespace_verdict), set by the caller.
  int32_t holds;              ///< 1 where a step was checked, nothing was found, and nothing left
                              ///< unseen; else 0.
  int32_t reserved;           ///< Zero.
  uint64_t moments;           ///< How many times were taken.
  uint64_t steps;             ///< How many steps were checked.
  uint64_t unseen;            ///< How many steps were not seen, by beespace_verifier_skip().
  uint64_t losses;            ///< Losses of separation: pairs, counted anew in each step.
  uint64_t clearance_losses;  ///< Losses of clearance: agents, counted anew in each step.
  uint64_t breaches;          ///< Breaches of limits.
  int64_t closest_first;      ///< One of the closest two; -1 where none came closer than twice the
                              ///< threshold.
  int64_t closest_second;     ///< The other.
  double closest_m;           ///< How close they came, in metres, to a millionth of the threshold,
                              ///< and never more than it was; NaN where none did.
  double closest_step_s;      ///< When that step began, in seconds; NaN where none did.
  double peak_speed_mps;      ///< The greatest speed, in metres per second.
  double peak_acceleration_mps2;  ///< The greatest acceleration, in metres per second squared; NaN
                                  ///< of straight lines.
} beespace_verdict;

/// @brief Says what was found so far.
/// @param verifier The verifier.
/// @param[out] verdict The verdict.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_verifier_verdict(const beespace_verifier* verifier,
                                                       beespace_verdict* verdict,
                                                       beespace_error* error);

/// @brief The kinds of violations.
enum beespace_violation_kinds {
  BEESPACE_VIOLATION_LOSS = 0,         ///< Two agents closer than the threshold.
  BEESPACE_VIOLATION_CLEARANCE = 1,    ///< An agent closer to an obstacle than the clearance.
  BEESPACE_VIOLATION_SPEED = 2,        ///< An agent faster than `max_speed_mps`.
  BEESPACE_VIOLATION_ACCELERATION = 3  ///< An agent that accelerates more than it may.
};

/// @brief Names a kind of violation as the command does: "loss", "clearance", "speed",
/// "acceleration".
/// @param kind BEESPACE_VIOLATION_LOSS ...
/// @return Its name; "unknown" for a number that is no kind. Valid for ever.
BEESPACE_C_API const char* beespace_violation_name(int32_t kind);

/// @brief Violations, each in one step, in columns; as beespace_events.
typedef struct beespace_violations beespace_violations;

/// @brief Makes a handle without violations.
/// @return The handle; NULL when there is no memory.
BEESPACE_C_API beespace_violations* beespace_violations_create(void);
/// @brief Frees violations and their arrays.
/// @param violations The violations; NULL does nothing.
BEESPACE_C_API void beespace_violations_free(beespace_violations* violations);
/// @brief Says how many violations there are.
/// @param violations The violations.
/// @return Their number; 0 of NULL.
BEESPACE_C_API int64_t beespace_violations_size(const beespace_violations* violations);
/// @brief Gives what was found: BEESPACE_VIOLATION_LOSS ...
/// @param violations The violations.
/// @return The kinds.
BEESPACE_C_API const int32_t* beespace_violations_kinds(const beespace_violations* violations);
/// @brief Gives the agent of each violation; of a loss the one of the smaller index.
/// @param violations The violations.
/// @return The indices.
BEESPACE_C_API const int64_t* beespace_violations_first(const beespace_violations* violations);
/// @brief Gives, of a loss, the other agent; of clearance, the first obstacle to which the agent
/// came too close.
/// @param violations The violations.
/// @return The indices; -1 of other violations.
BEESPACE_C_API const int64_t* beespace_violations_second(const beespace_violations* violations);
/// @brief Gives when the step of each violation begins, in seconds.
/// @param violations The violations.
/// @return The times.
BEESPACE_C_API const double* beespace_violations_begins_s(const beespace_violations* violations);
/// @brief Gives when the step of each violation ends, in seconds.
/// @param violations The violations.
/// @return The times.
BEESPACE_C_API const double* beespace_violations_ends_s(const beespace_violations* violations);
/// @brief Gives how close they came in the step, in metres, below zero inside of an obstacle; or
/// the greatest speed or acceleration, in metres per second or per second squared.
/// @param violations The violations.
/// @return The values.
BEESPACE_C_API const double* beespace_violations_values(const beespace_violations* violations);

/// @brief Gives what was found: losses, losses of clearance and breaches, one kind after the other,
/// each in the order of time. Of each of the three the first 1000; the verdict counts all.
/// @param verifier The verifier.
/// @param[out] violations The violations; none after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_verifier_violations(const beespace_verifier* verifier,
                                                          beespace_violations* violations,
                                                          beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
