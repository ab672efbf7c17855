/// @file
/// @brief Guides a fleet whose positions are not exact, and whose messages are late or lost. Part
/// of <beespace.h>.
///
/// A guide plans on *nominal* states, which it knows exactly, as it made them. It keeps all
/// branches on which an agent can still be (fleet.h), claims the hull of all of them, and keeps
/// claims apart. The true agent is in a tube around its nominal path. So as long as the figures of
/// the fleet are true, *true* positions keep the threshold, whatever is lost, delayed, doubled or
/// put out of order. An agent whose figures do not hold is named. docs/prevention.md has the proof.
#ifndef BEESPACE_C_GUIDE_H
#define BEESPACE_C_GUIDE_H

#include <beespace/c/advise.h>
#include <beespace/c/fleet.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief What a guide needs to know. All is copied.
typedef struct beespace_guide_options {
  size_t struct_size;  ///< sizeof(beespace_guide_options)
  uint32_t flags;      ///< BEESPACE_PLANAR: agents keep their heights.
  uint32_t reserved;   ///< Zero.
  uint32_t epoch;    ///< Greater than that of every planner that guided this fleet before; 0 is 1.
  uint32_t threads;  ///< As beespace_run::threads.
  double threshold_m;      ///< The threshold in metres, above zero. There is no default.
  double vertical_factor;  ///< As of beespace_advise_options.
  double vertical_m;       ///< As of beespace_advise_options.
  int32_t shape;           ///< BEESPACE_FREE_SPHERE, ...
  int32_t more_reserved;   ///< Zero.
  const beespace_fleet_figures*
      figures;                        ///< Of each agent that has none of its own; NULL: perfect.
  const beespace_link_figures* link;  ///< How messages go; NULL: as one of zeros.
  double max_speed_mps;          ///< The greatest speed of each agent that has none of its own.
  double max_acceleration_mps2;  ///< The greatest acceleration of each that has none of its own.
  double clearance_m;            ///< From obstacles and fences; as of beespace_advise_options.
  const beespace_obstacles* obstacles;      ///< The static obstacles; or NULL.
  const beespace_points* fence_directions;  ///< As of beespace_advise_options.
  const double* fence_offsets_m;            ///< As of beespace_advise_options.
  double intruder_horizon_s;  ///< How far to look ahead for intruders, in seconds; 0 is 10.
} beespace_guide_options;

/// @brief Guides a fleet, tick after tick. One call at a time.
///
/// An error of a call changes nothing, but for three: while intruders are refused no agent is clear
/// of them, a report of a branch that was never sent marks its agent, and a step that was stopped
/// has had its tick.
typedef struct beespace_guide beespace_guide;

/// @brief Makes a guide of no agents.
/// @param options What it needs to know.
/// @param[out] guide The guide, to be freed by beespace_guide_free(); NULL after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: BEESPACE_INVALID_THRESHOLD;
///   BEESPACE_INVALID_ARGUMENT: as beespace_advise() and beespace_tube_of();
///   BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_guide_create(const beespace_guide_options* options,
                                                   beespace_guide** guide, beespace_error* error);
/// @brief Frees a guide.
/// @param guide The guide; NULL does nothing.
BEESPACE_C_API void beespace_guide_free(beespace_guide* guide);

/// @brief An agent that wants to join. It stands, and will hold its place.
typedef struct beespace_join_request {
  size_t struct_size;  ///< sizeof(beespace_join_request)
  uint32_t promised;   ///< What its follower has promised: beespace_stored_branch::promised.
  uint32_t reserved;   ///< Zero.
  int64_t agent;       ///< The caller's number.
  double position[3];  ///< Where it stands, in metres.
  double radius_m;     ///< Its own radius in metres; zero or more.
  const beespace_fleet_figures* figures;  ///< Its own figures; NULL: those of the options.
  double max_speed_mps;          ///< Its own limits; where both are 0, those of the options.
  double max_acceleration_mps2;  ///< Its own limits; where both are 0, those of the options.
} beespace_join_request;

/// @brief Whether an agent may join. One that may not is not planned for, and certificates do not
/// count it: let it move, or give it as an intruder. Arrays belong to the guide, and are valid
/// until its next call; they are NULL where they are empty.
typedef struct beespace_join_answer {
  size_t struct_size;        ///< sizeof(beespace_join_answer), set by the caller.
  int32_t joined;            ///< 1 where its place is reserved: it is in the fleet; else 0.
  int32_t reserved;          ///< Zero.
  const int64_t* touches;    ///< Whose claims it would touch.
  const int64_t* obstacles;  ///< Which obstacles it is too close to, by index.
  const int64_t* fences;     ///< Which fences it is too close to, by index.
  int64_t touch_count;       ///< How many `touches` there are.
  int64_t obstacle_count;    ///< How many `obstacles` there are.
  int64_t fence_count;       ///< How many `fences` there are.
} beespace_join_answer;

/// @brief Says whether an agent may join; and if so, it has joined: its place is reserved.
///
/// The next step has a root command for it, again and again until it is acknowledged.
///
/// @param guide The guide.
/// @param request The agent.
/// @param[out] answer Whether it has joined, and if not why.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK, also where it has not joined; or the code of the error:
///   BEESPACE_INVALID_ARGUMENT: it has joined already, or left so lately that it may still take
///   what was sent to it; figures or limits as beespace_tube_of(); BEESPACE_NOT_FINITE,
///   BEESPACE_OUTSIDE_DOMAIN: its position; BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_guide_join(beespace_guide* guide,
                                                 const beespace_join_request* request,
                                                 beespace_join_answer* answer,
                                                 beespace_error* error);
/// @brief The same without joining: `joined` is 0, and it may join where it touches nothing.
/// @param guide The guide.
/// @param request The agent.
/// @param[out] answer As of beespace_guide_join().
/// @param[out] error What went wrong; or NULL.
/// @return As beespace_guide_join().
BEESPACE_C_API beespace_code beespace_guide_may_join(beespace_guide* guide,
                                                     const beespace_join_request* request,
                                                     beespace_join_answer* answer,
                                                     beespace_error* error);
/// @brief Takes over an agent that another planner has guided, and that has promised this epoch. It
/// may not be clear of others: then the pairs are named.
/// @param guide The guide.
/// @param request The agent; its position counts for nothing.
/// @param stored What its follower says after beespace_follower_promise().
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error: as beespace_guide_join(), or for a branch that
///   cannot be.
BEESPACE_C_API beespace_code beespace_guide_adopt(beespace_guide* guide,
                                                  const beespace_join_request* request,
                                                  const beespace_stored_branch* stored,
                                                  beespace_error* error);
/// @brief Says that agents exist of which nothing is known yet: until all are adopted, or removed,
/// no agent is certified.
/// @param guide The guide.
/// @param agents Their numbers.
/// @param count How many there are.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_guide_expect(beespace_guide* guide, const int64_t* agents,
                                                   int64_t count, beespace_error* error);
/// @brief Removes an agent: it has landed, or was found. Its place is free.
/// @param guide The guide.
/// @param agent Its number.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: it is not known.
BEESPACE_C_API beespace_code beespace_guide_leave(beespace_guide* guide, int64_t agent,
                                                  beespace_error* error);
/// @brief Says where an agent shall go, and stop.
/// @param guide The guide.
/// @param agent Its number.
/// @param goal The place, in metres.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: it is not known; BEESPACE_NOT_FINITE,
///   BEESPACE_OUTSIDE_DOMAIN.
BEESPACE_C_API beespace_code beespace_guide_set_goal(beespace_guide* guide, int64_t agent,
                                                     const double goal[3], beespace_error* error);
/// @brief Says which velocity an agent prefers, instead of a goal.
/// @param guide The guide.
/// @param agent Its number.
/// @param velocity The velocity, in metres per second.
/// @param[out] error What went wrong; or NULL.
/// @return As beespace_guide_set_goal().
BEESPACE_C_API beespace_code beespace_guide_set_preferred(beespace_guide* guide, int64_t agent,
                                                          const double velocity[3],
                                                          beespace_error* error);
/// @brief Takes a report: in any order, any number of times.
/// @param guide The guide.
/// @param report The report.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: an agent that is not known, a branch that was
///   never sent; BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN. An agent that is on a branch that
///   was never sent is named in the next step.
BEESPACE_C_API beespace_code beespace_guide_take_report(beespace_guide* guide,
                                                        const beespace_agent_report* report,
                                                        beespace_error* error);
/// @brief Takes an acknowledgement: in any order, any number of times.
/// @param guide The guide.
/// @param acknowledgement The acknowledgement.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: of an agent that is not known, or of a
/// command
///   that was never sent.
BEESPACE_C_API beespace_code beespace_guide_take_acknowledgement(
    beespace_guide* guide, const beespace_acknowledgement* acknowledgement, beespace_error* error);
/// @brief Says which intruders there are from now on: they are taken to fly straight on until the
/// next call.
/// @param guide The guide.
/// @param positions Where they are now, in metres.
/// @param velocities How fast, in metres per second; as many.
/// @param radii_m The radius of each, in metres; or NULL: 0.
/// @param position_errors_m How far each may be from there, in metres; or NULL: 0.
/// @param speed_errors_mps How far its velocity may be off, in metres per second; or NULL: 0.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN, BEESPACE_INVALID_ARGUMENT:
///   one that cannot be used, by its index in beespace_error::record. It may be anywhere: until the
///   next call no agent is clear of intruders, and the others are given way to. (After an error of
///   arrays that do not fit all is as before.)
BEESPACE_C_API beespace_code beespace_guide_set_intruders(
    beespace_guide* guide, const beespace_points* positions, const beespace_points* velocities,
    const double* radii_m, const double* position_errors_m, const double* speed_errors_mps,
    beespace_error* error);

/// @brief How many agents there are.
/// @param guide The guide.
/// @return The number; 0 of NULL.
BEESPACE_C_API int64_t beespace_guide_size(const beespace_guide* guide);
/// @brief The tube of an agent.
/// @param guide The guide.
/// @param agent Its number.
/// @param[out] tube The tube.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: it is not known.
BEESPACE_C_API beespace_code beespace_guide_tube(const beespace_guide* guide, int64_t agent,
                                                 beespace_tube* tube, beespace_error* error);
/// @brief The claim of an agent: the places whose convex hull it is.
/// @param guide The guide.
/// @param agent Its number.
/// @param[out] xyz The places in metres, interleaved. They belong to the guide, and are valid until
///   its next call.
/// @param[out] count How many places there are.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: it is not known.
BEESPACE_C_API beespace_code beespace_guide_claim(beespace_guide* guide, int64_t agent,
                                                  const double** xyz, int64_t* count,
                                                  beespace_error* error);

/* ---- A step --------------------------------------------------------------------------------- */

/// @brief What a guide says in one tick, in columns. Each call that is given it overwrites it.
/// Arrays belong to it, and are valid until its next call or end.
typedef struct beespace_guidance beespace_guidance;
/// @brief Makes an empty one.
/// @return The guidance; NULL when there is no memory.
BEESPACE_C_API beespace_guidance* beespace_guidance_create(void);
/// @brief Frees guidance and its arrays.
/// @param guidance The guidance; NULL does nothing.
BEESPACE_C_API void beespace_guidance_free(beespace_guidance* guidance);

/// @brief Guides the fleet for one tick: to be called at its begin, after the messages that came
/// until then.
/// @param guide The guide.
/// @param now The tick; after that of the call before.
/// @param run What ends the call early; or NULL. The tick has passed all the same. (Threads are
/// those
///   of the options.)
/// @param[out] guidance What to send, and what is known; empty after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_TIME_ORDER, BEESPACE_INVALID_ARGUMENT: a tick that is not after
///   the one before, or beyond 10^18; BEESPACE_STOPPED, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_guide_step(beespace_guide* guide, int64_t now,
                                                 const beespace_run* run,
                                                 beespace_guidance* guidance,
                                                 beespace_error* error);

/// @brief Whether an agent keeps the contract of its figures.
enum beespace_contract_states {
  BEESPACE_CONTRACT_KEPT = 0,     ///< As far as reports tell.
  BEESPACE_CONTRACT_DOUBTED = 1,  ///< It may have left its tube.
  BEESPACE_CONTRACT_OUT = 2       ///< It surely has left it, or deviates faster than it can.
};
/// @brief Why a contract is doubted or broken.
enum beespace_contract_reasons {
  BEESPACE_REASON_NONE = 0,       ///< It is kept.
  BEESPACE_REASON_DEVIATION = 1,  ///< It is too far from where it should be.
  BEESPACE_REASON_RATE = 2,       ///< Its deviation changes faster than the figures allow.
  BEESPACE_REASON_SILENT = 3,     ///< It was not heard of for longer than the figures say.
  BEESPACE_REASON_NO_BRANCH = 4,  ///< It lost its branch, or says that it is on one that cannot be.
  BEESPACE_REASON_FUTURE = 5      ///< Its report comes from the future.
};

/// @brief The tick of the step.
/// @param guidance The guidance.
/// @return The tick.
BEESPACE_C_API int64_t beespace_guidance_tick(const beespace_guidance* guidance);
/// @brief How many agents there are.
/// @param guidance The guidance.
/// @return The length of each column, all of which are in ascending order of agents.
BEESPACE_C_API int64_t beespace_guidance_size(const beespace_guidance* guidance);
/// @brief Gives the agents.
/// @param guidance The guidance.
/// @return Their numbers; NULL of no agent.
BEESPACE_C_API const int64_t* beespace_guidance_agents(const beespace_guidance* guidance);
/// @brief Gives whether each keeps its contract: BEESPACE_CONTRACT_KEPT, ...
/// @param guidance The guidance.
/// @return One for each agent; NULL of no agent.
BEESPACE_C_API const int32_t* beespace_guidance_contracts(const beespace_guidance* guidance);
/// @brief Gives why not: BEESPACE_REASON_NONE, ...
/// @param guidance The guidance.
/// @return As beespace_guidance_contracts().
BEESPACE_C_API const int32_t* beespace_guidance_reasons(const beespace_guidance* guidance);
/// @brief Gives the all-clear: what beespace_guidance_keeps_apart() and
/// beespace_guidance_clear_of_intruders() give, and a contract that is kept.
/// @param guidance The guidance.
/// @return 1 or 0 for each agent; NULL of no agent.
BEESPACE_C_API const uint8_t* beespace_guidance_certified(const beespace_guidance* guidance);
/// @brief Gives what is proven: as long as all keep the contract, the agent keeps the threshold
/// from all others that keep it, and the clearance, for ever.
/// @param guidance The guidance.
/// @return As beespace_guidance_certified().
BEESPACE_C_API const uint8_t* beespace_guidance_keeps_apart(const beespace_guidance* guidance);
/// @brief Gives what is predicted: no intruder comes too close, if all fly straight on, and the
/// agent on its newest branch and as it is told now.
/// @param guidance The guidance.
/// @return As beespace_guidance_certified().
BEESPACE_C_API const uint8_t* beespace_guidance_clear_of_intruders(
    const beespace_guidance* guidance);
/// @brief Gives how each flies, compared with what is preferred: BEESPACE_AS_PREFERRED, ...
/// @param guidance The guidance.
/// @return As beespace_guidance_contracts().
BEESPACE_C_API const int32_t* beespace_guidance_kinds(const beespace_guidance* guidance);
/// @brief Gives whether there is a command for it in this tick.
/// @param guidance The guidance.
/// @return As beespace_guidance_certified().
BEESPACE_C_API const uint8_t* beespace_guidance_commanded(const beespace_guidance* guidance);
/// @brief Gives on how many branches each can be.
/// @param guidance The guidance.
/// @return As beespace_guidance_contracts().
BEESPACE_C_API const int32_t* beespace_guidance_branches(const beespace_guidance* guidance);
/// @brief Gives the nominal position of each now, on its newest branch.
/// @param guidance The guidance.
/// @return 3 * beespace_guidance_size() numbers, interleaved, in metres; NULL of no agent.
BEESPACE_C_API const double* beespace_guidance_positions(const beespace_guidance* guidance);
/// @brief Gives the nominal velocity of each now.
/// @param guidance The guidance.
/// @return As beespace_guidance_positions(), in metres per second.
BEESPACE_C_API const double* beespace_guidance_velocities(const beespace_guidance* guidance);
/// @brief Gives the radius of the tube of each, in metres.
/// @param guidance The guidance.
/// @return One for each agent; NULL of no agent.
BEESPACE_C_API const double* beespace_guidance_tubes_m(const beespace_guidance* guidance);
/// @brief Gives how far each deviated by its last report, in metres; 0 before the first.
/// @param guidance The guidance.
/// @return As beespace_guidance_tubes_m().
BEESPACE_C_API const double* beespace_guidance_deviations_m(const beespace_guidance* guidance);

/// @brief Says how many commands are to be sent.
/// @param guidance The guidance.
/// @return The number.
BEESPACE_C_API int64_t beespace_guidance_command_count(const beespace_guidance* guidance);
/// @brief Gives one command, in ascending order of agents.
/// @param guidance The guidance.
/// @param index Which, below beespace_guidance_command_count().
/// @return The command, which belongs to the guidance; NULL where there is no such one.
BEESPACE_C_API const beespace_command* beespace_guidance_command(const beespace_guidance* guidance,
                                                                 int64_t index);
/// @brief Gives one list of what is not certified, and why. Its agents are numbers of the caller's.
/// @param guidance The guidance.
/// @param what BEESPACE_TOO_CLOSE: two agents without a certificate; BEESPACE_NEAR_OBSTACLE,
///   BEESPACE_NEAR_FENCE, or BEESPACE_INTRUDER_CONFLICTS, which is without times here.
/// @param[out] findings The list.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: there is no such list, or a pointer is NULL.
BEESPACE_C_API beespace_code beespace_guidance_findings(const beespace_guidance* guidance,
                                                        int32_t what, beespace_findings* findings,
                                                        beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
