/// @file
/// @brief A live swarm: position reports go in, events come out. Part of <beespace.h>.
///
/// What has happened is derived from reports alone: between two reports that are no more than
/// beespace_swarm_options::max_age_s apart an agent moves in the straight line through both. Where
/// reports come in the order of their times, what *entered*, *closest passed*, *left* and was
/// *lost* is exact, and does not depend on how often beespace_swarm_advance() is called. Silence is
/// not absence: an agent that is not heard of is *stale*, which is somewhere unknown, until it is
/// heard of again or removed.
#ifndef BEESPACE_C_SWARM_H
#define BEESPACE_C_SWARM_H

#include <beespace/c/recording.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief The flags of beespace_swarm_options::flags: what is given. A value whose flag is not set
/// must be zero.
enum beespace_swarm_flags {
  BEESPACE_SWARM_VERTICAL = 1,       ///< `vertical_m`: a vertical threshold.
  BEESPACE_SWARM_HEIGHTS_APART = 2,  ///< With that: heights are those that reports give apart from
                                     ///< positions (beespace_fixes::heights_m), not z.
  BEESPACE_SWARM_HORIZON = 4,        ///< `horizon_s`: how far to look ahead.
  BEESPACE_SWARM_MAX_SPEED = 8       ///< `max_speed_mps`: the greatest speed of all agents.
};

/// @brief What a live swarm needs to know. Zero means the default wherever there is one.
typedef struct beespace_swarm_options {
  size_t struct_size;    ///< sizeof(beespace_swarm_options)
  uint32_t flags;        ///< BEESPACE_SWARM_VERTICAL | ...
  uint32_t threads;      ///< As beespace_run::threads: events are the same for every number.
  double threshold_m;    ///< The threshold in metres, above zero. There is no default.
  double vertical_m;     ///< The vertical threshold, in metres or in the unit of `height_unit_m`.
  double leave_factor;   ///< A pair has left when it is farther apart than the thresholds times
                         ///< this; 1 or more; 0 is 1.1.
  double horizon_s;      ///< Seconds; 0: no predictions. Without its flag 10.
  double max_age_s;      ///< An agent that has not been heard of for longer, in seconds, is stale;
                         ///< 0 is 5.
  double height_unit_m;  ///< The length in metres of one unit of heights that are apart; 0 is 1.
  double max_speed_mps;  ///< Metres per second, heights included: conflicts that a stale agent may
                         ///< be in are then reported as *possible*.
  uint64_t max_agents;   ///< How many agents are known at a time; 0 is 1,000,000.
  uint64_t max_pairs;    ///< How many pairs are followed at a time; 0 is 500,000.
  uint64_t reserved;     ///< Zero.
} beespace_swarm_options;

/// @brief A live swarm, in memory of its own. It serves one call at a time.
typedef struct beespace_swarm beespace_swarm;

/// @brief Makes a swarm without agents.
/// @param options What it needs to know.
/// @param[out] swarm The swarm, to be freed by beespace_swarm_free(); NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_INVALID_THRESHOLD,
///   BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_swarm_create(const beespace_swarm_options* options,
                                                   beespace_swarm** swarm, beespace_error* error);
/// @brief Frees a swarm.
/// @param swarm The swarm; NULL does nothing.
BEESPACE_C_API void beespace_swarm_free(beespace_swarm* swarm);

/// @brief Takes reports, one after the other, in any order of agents.
///
/// A report that cannot be is refused, and all others count. Of one agent, reports that are late,
/// repeated or contrary are left out, which is no error: beespace_swarm_counts() counts them.
///
/// @param swarm The swarm.
/// @param reports The agent and the time of each report; any number is an id. With
///   BEESPACE_SWARM_HEIGHTS_APART its height, too, and the climb rate, which is used where there is
///   a velocity.
/// @param positions The position of each report, in metres. How many there are says how many
/// reports
///   there are.
/// @param velocities The velocity of each report, in metres per second; or NULL. Where all axes of
///   one are NaN, it is not known: the last two reports tell.
/// @param[out] refused How many reports were refused; -1 where an argument makes no sense, and none
///   was taken. Or NULL.
/// @param[out] error What is wrong with the first one that was refused: beespace_error::place says
///   of which argument, beespace_error::record which report. Or NULL.
/// @return BEESPACE_OK where none was refused, or the code of the error:
///   - BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN: a value that is not of the motion domain, as
///     beespace_closest_approach() says;
///   - BEESPACE_TOO_MANY_POINTS: an agent beyond beespace_swarm_options::max_agents;
///   - BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY. After the latter some reports may have
///     been taken, and `refused` is -1.
BEESPACE_C_API beespace_code beespace_swarm_update(beespace_swarm* swarm,
                                                   const beespace_fixes* reports,
                                                   const beespace_points* positions,
                                                   const beespace_points* velocities,
                                                   int64_t* refused, beespace_error* error);

/// @brief Removes agents that are no longer there; pairs of them that had entered have left.
/// @param swarm The swarm.
/// @param ids The ids; those that are unknown are passed over.
/// @param count How many ids there are.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_swarm_remove(beespace_swarm* swarm, const int64_t* ids,
                                                   int64_t count, beespace_error* error);
/// @brief Breaks the lines of agents (a clock has stepped, or reports in between cannot be used):
/// they are stale from their last reports on, until they are heard of again.
/// @param swarm The swarm.
/// @param ids The ids; those that are unknown are passed over.
/// @param count How many ids there are.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_swarm_lose(beespace_swarm* swarm, const int64_t* ids,
                                                 int64_t count, beespace_error* error);

/* ---- Events --------------------------------------------------------------------------------- */

/// @brief The kinds of events, in the order in which those of one instant are reported.
enum beespace_event_kinds {
  BEESPACE_EVENT_PREDICTED = 0,       ///< A conflict lies ahead, or is there now.
  BEESPACE_EVENT_POSSIBLE = 1,        ///< A stale agent may be in conflict with another one.
  BEESPACE_EVENT_HEARD = 2,           ///< A stale agent has been heard of again.
  BEESPACE_EVENT_ENTERED = 3,         ///< Two agents have come closer than the threshold.
  BEESPACE_EVENT_CLOSEST_PASSED = 4,  ///< The distance of the two grows again.
  BEESPACE_EVENT_LEFT = 5,            ///< Far enough apart again, or one of the two was removed.
  BEESPACE_EVENT_STALE = 6,           ///< An agent has not been heard of for `max_age_s`.
  BEESPACE_EVENT_LOST = 7,            ///< One of two that had entered is unknown from then on.
  BEESPACE_EVENT_ENDED = 8,      ///< Of finish: two that had entered, and nothing more was heard.
  BEESPACE_EVENT_OVERLOADED = 9  ///< A bound was reached, and something was left out.
};

/// @brief The bound that was reached where a swarm is overloaded.
enum beespace_bounds {
  BEESPACE_BOUND_NONE = 0,       ///< None.
  BEESPACE_BOUND_AGENTS = 1,     ///< `max_agents`: reports of others were refused.
  BEESPACE_BOUND_PAIRS = 2,      ///< `max_pairs`, of pairs in conflict.
  BEESPACE_BOUND_PREDICTED = 3,  ///< `max_pairs`, of predicted pairs.
  BEESPACE_BOUND_POSSIBLE = 4    ///< `max_pairs`, of possible conflicts.
};

/// @brief Names a kind of event as the command does: "predicted", "closest_passed", ...
/// @param kind BEESPACE_EVENT_PREDICTED ...
/// @return Its name; "unknown" for a number that is no kind. Valid for ever.
BEESPACE_C_API const char* beespace_event_name(int32_t kind);
/// @brief Names a bound: "none", "agents", "pairs", "predicted", "possible".
/// @param bound BEESPACE_BOUND_NONE ...
/// @return Its name; "unknown" for a number that is no bound. Valid for ever.
BEESPACE_C_API const char* beespace_bound_name(int32_t bound);

/// @brief Events, in columns. Each call that is given the events overwrites them. Arrays have
/// beespace_events_size() entries, belong to the events, and are valid until their next call or
/// end; NULL where there is no event.
typedef struct beespace_events beespace_events;

/// @brief Makes a handle without events.
/// @return The handle; NULL when there is no memory.
BEESPACE_C_API beespace_events* beespace_events_create(void);
/// @brief Frees events and their arrays.
/// @param events The events; NULL does nothing.
BEESPACE_C_API void beespace_events_free(beespace_events* events);
/// @brief Says how many events there are.
/// @param events The events.
/// @return Their number; 0 of NULL.
BEESPACE_C_API int64_t beespace_events_size(const beespace_events* events);
/// @brief Gives what happened: BEESPACE_EVENT_PREDICTED ...
/// @param events The events.
/// @return The kinds.
BEESPACE_C_API const int32_t* beespace_events_kinds(const beespace_events* events);
/// @brief Gives when it happened, in seconds. Of a prediction: when the conflict begins; of a stale
/// agent: when it was last heard of; of lost and ended: until when both are known; of possible:
/// since when it may be so; of overloaded: the time that was advanced to.
/// @param events The events.
/// @return The times.
BEESPACE_C_API const double* beespace_events_times_s(const beespace_events* events);
/// @brief Gives one agent of each event; below the second.
/// @param events The events.
/// @return The ids; 0, which means nothing, where a bound of pairs was reached.
BEESPACE_C_API const int64_t* beespace_events_first(const beespace_events* events);
/// @brief Gives the other agent of each event; of stale, heard and overloaded the same as the
/// first.
/// @param events The events.
/// @return The ids.
BEESPACE_C_API const int64_t* beespace_events_second(const beespace_events* events);
/// @brief Gives the distance of the two at that time, in metres. Of a prediction: when they are
/// closest; of possible: where they were last heard of; of overloaded: from what distance on pairs
/// were left out; 0 where there are no two.
/// @param events The events.
/// @return The distances.
BEESPACE_C_API const double* beespace_events_distances_m(const beespace_events* events);
/// @brief Gives when the two are closest, in seconds: in the future of a prediction, otherwise so
/// far. Of events of no pair the time of the event.
/// @param events The events.
/// @return The times.
BEESPACE_C_API const double* beespace_events_closest_s(const beespace_events* events);
/// @brief Gives, of heard, stale, lost and possible, since when the agent has been silent, in
/// seconds; of two silent ones that with the longer silence.
/// @param events The events.
/// @return The times; NaN of other events.
BEESPACE_C_API const double* beespace_events_since_s(const beespace_events* events);
/// @brief Gives, of overloaded, how many were left out, at least; 0: not known.
/// @param events The events.
/// @return The numbers; 0 of other events.
BEESPACE_C_API const int64_t* beespace_events_left_out(const beespace_events* events);
/// @brief Gives, of overloaded, the bound: BEESPACE_BOUND_AGENTS ...
/// @param events The events.
/// @return The bounds; BEESPACE_BOUND_NONE of other events.
BEESPACE_C_API const int32_t* beespace_events_bounds(const beespace_events* events);

/// @brief Reports what has happened since the last call, and what is predicted.
///
/// It cannot be stopped half-way: the next call would not know what has been reported. The bounds
/// of the options limit how long it takes. After BEESPACE_OUT_OF_MEMORY events may be missing: make
/// a new swarm.
///
/// @param swarm The swarm.
/// @param now_s The time in seconds, by which the age of reports is judged.
/// @param[out] events In ascending order of time, kind, first and second; none after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_TIME_ORDER where `now_s` is before that
/// of
///   the last call, BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN, BEESPACE_INVALID_ARGUMENT,
///   BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_swarm_advance(beespace_swarm* swarm, double now_s,
                                                    beespace_events* events, beespace_error* error);
/// @brief The last beespace_swarm_advance(): nothing more will be heard. Pairs that have entered
/// and neither left nor been lost have ended. No agent is known afterwards, and times may begin
/// anew; counts go on.
/// @param swarm The swarm.
/// @param now_s As of beespace_swarm_advance().
/// @param[out] events As of beespace_swarm_advance().
/// @param[out] error What went wrong; or NULL.
/// @return As beespace_swarm_advance().
BEESPACE_C_API beespace_code beespace_swarm_finish(beespace_swarm* swarm, double now_s,
                                                   beespace_events* events, beespace_error* error);
/// @brief As beespace_swarm_finish(), but all agents stay known: times begin anew.
/// @param swarm The swarm.
/// @param now_s The time in seconds, as it was.
/// @param then_s The same instant in seconds, as it is from now on.
/// @param[out] events As of beespace_swarm_advance().
/// @param[out] error What went wrong; or NULL.
/// @return As beespace_swarm_advance().
BEESPACE_C_API beespace_code beespace_swarm_begin_anew(beespace_swarm* swarm, double now_s,
                                                       double then_s, beespace_events* events,
                                                       beespace_error* error);

/* ---- What is known now ---------------------------------------------------------------------- */

/// @brief What became of the reports.
typedef struct beespace_counts {
  size_t struct_size;   ///< sizeof(beespace_counts), set by the caller.
  uint64_t taken;       ///< Reports that were used.
  uint64_t repeated;    ///< The same time and position again: left out.
  uint64_t late;        ///< Before a report of the same agent that was used: left out.
  uint64_t contrary;    ///< The time of one of the last two again, elsewhere: left out.
  uint64_t refused;     ///< Of an agent beyond `max_agents`: left out.
  uint64_t agents;      ///< Agents that are known and not stale, now.
  uint64_t stale;       ///< Agents that are stale, now.
  uint64_t heard_once;  ///< Agents that are known from one report only.
  uint64_t predicted;   ///< Pairs of which a predicted conflict has neither begun nor been averted.
  double unknown_s;  ///< For how long agents have been unknown in all, in seconds, where they have
                     ///< been heard of again.
  double missed_s;   ///< How far the first reports of agents, or their first after a silence, were
                    ///< before what was still known of the others, in seconds in all: what happened
                    ///< in these times is not found.
} beespace_counts;

/// @brief Says what became of the reports.
/// @param swarm The swarm.
/// @param[out] counts The counts.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_swarm_counts(const beespace_swarm* swarm,
                                                   beespace_counts* counts, beespace_error* error);

/// @brief Known agents, in columns; as beespace_events.
typedef struct beespace_movers beespace_movers;

/// @brief Makes a handle without agents.
/// @return The handle; NULL when there is no memory.
BEESPACE_C_API beespace_movers* beespace_movers_create(void);
/// @brief Frees agents and their arrays.
/// @param movers The agents; NULL does nothing.
BEESPACE_C_API void beespace_movers_free(beespace_movers* movers);
/// @brief Says how many agents there are.
/// @param movers The agents.
/// @return Their number; 0 of NULL.
BEESPACE_C_API int64_t beespace_movers_size(const beespace_movers* movers);
/// @brief Gives the ids of the agents, ascending.
/// @param movers The agents.
/// @return The ids.
BEESPACE_C_API const int64_t* beespace_movers_ids(const beespace_movers* movers);
/// @brief Gives where the agents would be, in metres: on straight lines from their last reports
/// where they move; otherwise where they were last heard of, and may have left since.
/// @param movers The agents.
/// @return Three coordinates of each.
BEESPACE_C_API const double* beespace_movers_positions(const beespace_movers* movers);
/// @brief Gives the velocities of the agents, in metres per second.
/// @param movers The agents.
/// @return Three of each; 0 where beespace_movers_move() is 0, which does not say that it stands.
BEESPACE_C_API const double* beespace_movers_velocities(const beespace_movers* movers);
/// @brief Gives when each agent was last heard of, in seconds.
/// @param movers The agents.
/// @return The times.
BEESPACE_C_API const double* beespace_movers_heard_s(const beespace_movers* movers);
/// @brief Gives where each agent was last heard of, in metres.
/// @param movers The agents.
/// @return Three coordinates of each.
BEESPACE_C_API const double* beespace_movers_heard_at(const beespace_movers* movers);
/// @brief Says of each agent whether it was stale when the swarm last advanced.
/// @param movers The agents.
/// @return 1 or 0.
BEESPACE_C_API const uint8_t* beespace_movers_stale(const beespace_movers* movers);
/// @brief Says of each agent whether it is not stale and its velocity is known.
/// @param movers The agents.
/// @return 1 or 0.
BEESPACE_C_API const uint8_t* beespace_movers_move(const beespace_movers* movers);
/// @brief Gives for how long each agent has been unknown in all, until the time that was asked
/// about, in seconds.
/// @param movers The agents.
/// @return The lengths of time.
BEESPACE_C_API const double* beespace_movers_unknown_s(const beespace_movers* movers);

/// @brief Says where all agents are that have not been removed: stale ones, and those heard of
/// once, too. Heights that are kept apart are left out.
/// @param swarm The swarm.
/// @param time_s The time in seconds.
/// @param[out] movers The agents; none after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN, BEESPACE_INVALID_ARGUMENT,
///   BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_swarm_movers(const beespace_swarm* swarm, double time_s,
                                                   beespace_movers* movers, beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
