/// @file
/// @brief A fleet that is not exact: how far from its path an agent can be, what planner and agent
/// tell each other, and the agent's side of that. Part of <beespace.h>.
///
/// Time is counted in *ticks*, one for each period of the planner. A *branch* is a nominal path:
/// states at successive ticks, between which velocities change evenly, and after the last of which
/// the agent brakes to a stop and stays. A command is a branch, and says from which others it
/// departs, and when. docs/prevention.md has the rules, and why they hold however messages are
/// lost, delayed, doubled and put out of order.
#ifndef BEESPACE_C_FLEET_H
#define BEESPACE_C_FLEET_H

#include <beespace/c/basics.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Figures -------------------------------------------------------------------------------- */

/// @brief Where the loop that keeps an agent on its path is closed.
enum beespace_loop_places {
  BEESPACE_LOOP_ONBOARD = 0,  ///< The agent measures where it is, and corrects.
  BEESPACE_LOOP_GROUND = 1    ///< The planner does, by reports and commands. What is promised ends
                              ///< where these do.
};

/// @brief The figures of a fleet, or of one agent: all of them bounds, none a mean. One that is 0
/// is perfect.
typedef struct beespace_fleet_figures {
  size_t struct_size;      ///< sizeof(beespace_fleet_figures)
  int32_t loop;            ///< BEESPACE_LOOP_ONBOARD or BEESPACE_LOOP_GROUND.
  int32_t reserved;        ///< Zero.
  double report_error_m;   ///< How far at most a reported position is from the true one, in metres.
  double report_age_s;     ///< How old at most the newest report is when it is used, in seconds.
  double sensing_error_m;  ///< On board: how far at most from the true position is what the agent
                           ///< takes for it, in metres.
  double loop_period_s;    ///< On board: the period of its loop, in seconds; 0: it is continuous.
  double loop_delay_s;     ///< On board: how old at most a measurement is when it begins to act.
  double deviation_mps;  ///< How fast at most all things together carry it off its path, in metres
                         ///< per second: wind, drift, errors of velocity.
  double clock_error_s;  ///< How far at most its clock is off, in seconds.
  double correction_mps2;  ///< How much of the greatest acceleration is kept for corrections.
  double correction_mps;   ///< How much of the greatest speed is kept for corrections.
} beespace_fleet_figures;

/// @brief How the planner talks with a fleet.
typedef struct beespace_link_figures {
  size_t struct_size;     ///< sizeof(beespace_link_figures)
  int64_t reserved;       ///< Zero.
  double period_s;        ///< A tick, in seconds; 0 is 0.1.
  int32_t command_delay;  ///< After how many ticks a command takes effect, 1 to 32; 0 is 1.
  int32_t longest_loss;   ///< How many messages of an agent, one after the other, are lost at most.
} beespace_link_figures;

/// @brief The tube of an agent, and the loop that keeps it there.
typedef struct beespace_tube {
  size_t struct_size;        ///< sizeof(beespace_tube), set by the caller.
  int64_t reserved;          ///< Zero.
  double radius_m;           ///< It is never farther from its nominal place, in metres.
  double clock_m;            ///< What of this is for its clock, in metres.
  double error_m;            ///< The error that its loop works with, delays included, in metres.
  double gain_per_s;         ///< Deviations shrink as exp(-gain t); 0: nothing is to be corrected.
  double correction_mps2;    ///< The greatest acceleration that the loop asks for.
  double correction_mps;     ///< The greatest velocity that it asks for.
  double planned_speed_mps;  ///< What is left of the greatest speed for the plan.
  double planned_acceleration_mps2;  ///< What is left of the greatest acceleration for the plan.
} beespace_tube;

/// @brief Computes the smallest tube that the figures allow.
/// @param figures What is known of the agent; NULL: perfect.
/// @param link How the planner talks with it; NULL: as one of zeros.
/// @param max_speed_mps Its greatest speed, in metres per second.
/// @param max_acceleration_mps2 Its greatest acceleration, in metres per second squared.
/// @param[out] tube The tube.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: figures that cannot be, or contradict each
///   other; the message says which, with the numbers.
BEESPACE_C_API beespace_code beespace_tube_of(const beespace_fleet_figures* figures,
                                              const beespace_link_figures* link,
                                              double max_speed_mps, double max_acceleration_mps2,
                                              beespace_tube* tube, beespace_error* error);

/* ---- Messages ------------------------------------------------------------------------------- */

/// @brief The most states of a command.
#define BEESPACE_MOST_STATES 36
/// @brief The most ancestors of a command.
#define BEESPACE_MOST_ANCESTORS 16

/// @brief One state of a branch, at a tick. It never grows.
typedef struct beespace_branch_state {
  double position[3];    ///< Where an agent is, in metres.
  double velocity[3];    ///< How fast, in metres per second.
  double correction[3];  ///< What it flies in addition, where its loop is closed on the ground.
} beespace_branch_state;

/// @brief A branch that another one departs from. It never grows.
typedef struct beespace_ancestor {
  uint64_t number;  ///< The branch.
  int64_t departs;  ///< Up to this tick both lead the same way.
} beespace_ancestor;

/// @brief A command: the branch that one agent shall be on. Agents are known by any number of the
/// caller's; where they are in ascending order, negative ones come last.
typedef struct beespace_command {
  size_t struct_size;      ///< sizeof(beespace_command)
  int64_t reserved;        ///< Zero.
  int64_t agent;           ///< For whom.
  uint64_t number;         ///< The branch: the epoch of its planner in the upper 32 bits.
  int64_t starts;          ///< The tick of the first state.
  int32_t state_count;     ///< How many of `states` count; one or more.
  int32_t ancestor_count;  ///< How many of `ancestors` count; zero: a root.
  beespace_branch_state states[BEESPACE_MOST_STATES];    ///< At `starts` and each tick after it.
  beespace_ancestor ancestors[BEESPACE_MOST_ANCESTORS];  ///< In descending order.
} beespace_command;

/// @brief What an agent did with a command.
enum beespace_command_replies {
  BEESPACE_REPLY_TAKEN = 1,        ///< It is on that branch now.
  BEESPACE_REPLY_OLDER = 2,        ///< It is on that branch or a newer one, or refuses its epoch.
  BEESPACE_REPLY_TOO_LATE = 3,     ///< The branch that it is on has departed from it.
  BEESPACE_REPLY_TOO_EARLY = 4,    ///< The branch begins after the agent's tick. Not final.
  BEESPACE_REPLY_NO_ANCESTOR = 5,  ///< The branch that it is on is no ancestor. Not final.
  BEESPACE_REPLY_NO_BRANCH = 6,    ///< It has lost its branch, and must join anew.
  BEESPACE_REPLY_INVALID = 7       ///< Of another agent, or no command.
};

/// @brief The reply to one command.
typedef struct beespace_acknowledgement {
  size_t struct_size;  ///< sizeof(beespace_acknowledgement)
  int32_t reply;       ///< BEESPACE_REPLY_TAKEN, ...
  int32_t reserved;    ///< Zero.
  int64_t agent;       ///< Who replies.
  uint64_t number;     ///< Of the command.
  uint64_t held;       ///< The branch that it is on after that; or 0.
  int64_t tick;        ///< Its tick at that moment.
} beespace_acknowledgement;

/// @brief The flag of beespace_agent_report::flags.
enum beespace_report_flags {
  BEESPACE_WITH_VELOCITY = 1  ///< beespace_agent_report::velocity holds one.
};

/// @brief What an agent says about itself.
typedef struct beespace_agent_report {
  size_t struct_size;  ///< sizeof(beespace_agent_report)
  uint32_t flags;      ///< BEESPACE_WITH_VELOCITY
  uint32_t reserved;   ///< Zero.
  int64_t agent;       ///< Who reports.
  uint64_t held;       ///< The branch that it is on; 0: it lost it.
  int64_t tick;        ///< Its tick as it was measured.
  double after_s;      ///< How long after that tick, in seconds; zero or more.
  double position[3];  ///< Where it was measured to be, in metres.
  double velocity[3];  ///< How fast, in metres per second, where known.
} beespace_agent_report;

/// @brief What an agent must remember to go on after a restart.
typedef struct beespace_stored_branch {
  size_t struct_size;       ///< sizeof(beespace_stored_branch)
  uint32_t promised;        ///< It refuses epochs below this.
  uint32_t reserved;        ///< Zero.
  int64_t tick;             ///< Its tick.
  beespace_command branch;  ///< The branch that it is on, with its `struct_size`; number 0: none.
} beespace_stored_branch;

/* ---- The agent's side ----------------------------------------------------------------------- */

/// @brief The agent's side of the protocol: takes or refuses commands, and says where to be now. It
/// has no threads and no clock of its own.
typedef struct beespace_follower beespace_follower;

/// @brief Makes an agent that is on no branch.
/// @param agent Its number.
/// @param planned_speed_mps What is planned with (beespace_tube), in metres per second.
/// @param planned_acceleration_mps2 The same, in metres per second squared: by this it brakes.
/// @param period_s A tick, in seconds; above zero.
/// @param[out] follower The follower, to be freed by beespace_follower_free(); NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_follower_create(int64_t agent, double planned_speed_mps,
                                                      double planned_acceleration_mps2,
                                                      double period_s, beespace_follower** follower,
                                                      beespace_error* error);
/// @brief Frees a follower.
/// @param follower The follower; NULL does nothing.
BEESPACE_C_API void beespace_follower_free(beespace_follower* follower);
/// @brief Goes on after a restart with what was stored.
/// @param follower The follower.
/// @param stored What was stored.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: a follower of this agent cannot have stored
///   this.
BEESPACE_C_API beespace_code beespace_follower_restore(beespace_follower* follower,
                                                       const beespace_stored_branch* stored,
                                                       beespace_error* error);
/// @brief Sets the tick; it never runs backwards. Before the first call no command is taken.
/// @param follower The follower; NULL does nothing.
/// @param tick The tick by the agent's clock.
BEESPACE_C_API void beespace_follower_advance(beespace_follower* follower, int64_t tick);
/// @brief Takes a command or refuses it: anything may be in it.
/// @param follower The follower.
/// @param command The command, as it came.
/// @param[out] reply What was done. Where it was taken: store what beespace_follower_stored() says,
///   then send this.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK, also for a command that is refused; or BEESPACE_INVALID_ARGUMENT: a pointer
///   or a structure that is none.
BEESPACE_C_API beespace_code beespace_follower_receive(beespace_follower* follower,
                                                       const beespace_command* command,
                                                       beespace_acknowledgement* reply,
                                                       beespace_error* error);
/// @brief Answers a planner that was started anew: promises to refuse all older epochs.
/// @param follower The follower.
/// @param epoch The epoch of the planner.
/// @return 1 where it promises: then store what beespace_follower_stored() says, and send it. 0
/// where
///   the epoch is older than one that was promised before; or of NULL.
BEESPACE_C_API int32_t beespace_follower_promise(beespace_follower* follower, uint32_t epoch);
/// @brief Forgets its branch: the agent is not where it should be, and must join anew. Store what
/// beespace_follower_stored() says.
/// @param follower The follower; NULL does nothing.
BEESPACE_C_API void beespace_follower_lose(beespace_follower* follower);
/// @brief The branch that it is on.
/// @param follower The follower.
/// @return Its number; 0: none.
BEESPACE_C_API uint64_t beespace_follower_held(const beespace_follower* follower);
/// @brief The latest tick that it was told.
/// @param follower The follower.
/// @return The tick.
BEESPACE_C_API int64_t beespace_follower_tick(const beespace_follower* follower);
/// @brief What to store durably, wherever it has changed, before anything is sent.
/// @param follower The follower.
/// @param[out] stored What to store.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: a pointer or a structure that is none.
BEESPACE_C_API beespace_code beespace_follower_stored(const beespace_follower* follower,
                                                      beespace_stored_branch* stored,
                                                      beespace_error* error);

/// @brief Where an agent should be.
typedef struct beespace_setpoint {
  size_t struct_size;    ///< sizeof(beespace_setpoint), set by the caller.
  int32_t holding;       ///< 1 where it stands, at the end of its branch; else 0.
  int32_t reserved;      ///< Zero.
  double position[3];    ///< Where it should be, in metres.
  double velocity[3];    ///< How fast, in metres per second.
  double correction[3];  ///< What it flies in addition, in metres per second.
} beespace_setpoint;

/// @brief Says where it should be.
/// @param follower The follower.
/// @param after_s Seconds since its tick, zero or more.
/// @param[out] setpoint Where it should be.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: it is on no branch, and nothing can be said;
/// a
///   time that is no number or below zero; a pointer or a structure that is none.
BEESPACE_C_API beespace_code beespace_follower_setpoint(const beespace_follower* follower,
                                                        double after_s, beespace_setpoint* setpoint,
                                                        beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
