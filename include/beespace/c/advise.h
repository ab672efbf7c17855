/// @file
/// @brief Which velocity should each agent take next, so that all keep the threshold? Part of
/// <beespace.h>.
///
/// As long as all agents do as advised, agents that are *certified* do not come closer than the
/// threshold to each other, nor closer to an obstacle than the clearance: in this step and for ever
/// after, because each can always brake to a stop clear of all others. docs/prevention.md has the
/// proof and its conditions.
///
/// In a step an agent changes its velocity evenly from the old one to the new one, within its
/// greatest acceleration; one without such a limit flies with the new velocity from the start. The
/// next call begins where that leads, not at positions that are measured anew.
#ifndef BEESPACE_C_ADVISE_H
#define BEESPACE_C_ADVISE_H

#include <beespace/c/obstacles.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- What is given -------------------------------------------------------------------------- */

/// @brief What agents can do: one number for each agent, or one for all.
typedef struct beespace_limits {
  size_t struct_size;            ///< sizeof(beespace_limits)
  int64_t reserved;              ///< Zero.
  const double* max_speeds_mps;  ///< The greatest speed of the first agent, in metres per second.
  /// @brief The greatest acceleration of the first agent, in metres per second squared, above zero;
  /// or NULL: velocities change at once.
  const double* max_accelerations_mps2;
  ptrdiff_t max_speeds_stride;         ///< Bytes from one to the next; 0: it is that of all.
  ptrdiff_t max_accelerations_stride;  ///< Bytes from one to the next; 0: it is that of all.
} beespace_limits;

/// @brief The shapes of what must stay free around an agent, whose horizontal semi-axis is the
/// threshold.
enum beespace_free_shapes {
  BEESPACE_FREE_SPHERE = 0,     ///< Closer than the threshold, in any direction.
  BEESPACE_FREE_ELLIPSOID = 1,  ///< A sphere, stretched upwards and downwards: for rotor wash.
  BEESPACE_FREE_CYLINDER =
      2  ///< Closer horizontally than the threshold and vertically than a height.
};

/// @brief The methods that keep agents apart. All but the first promise nothing, certify no agent,
/// and ignore obstacles and intruders: they are there to be compared with.
enum beespace_advise_methods {
  BEESPACE_CERTIFIED = 0,  ///< The certified method of beespace.
  BEESPACE_ORCA = 1,       ///< Optimal reciprocal collision avoidance, in space.
  BEESPACE_MVP = 2         ///< Modified voltage potential.
};

/// @brief The flags of beespace_advise_options::flags, to be joined by `|`;
/// beespace_guide_options::flags has the first.
enum beespace_advise_flags {
  /// @brief All agents move in one horizontal plane: robots on a floor, ships. One whose height is
  /// not that of most, or whose vertical velocity is not zero, is refused.
  BEESPACE_PLANAR = 1,
  /// @brief The adviser remembers the planes between agents from one call with this flag to the
  /// next: one that certified a pair does so again. Should be set where there are claims. Agents
  /// must keep their indices; see beespace_adviser_forget().
  BEESPACE_REMEMBER = 2
};

/// @brief What advice needs to know. Arrays are read during the call.
typedef struct beespace_advise_options {
  size_t struct_size;      ///< sizeof(beespace_advise_options)
  uint32_t flags;          ///< BEESPACE_PLANAR | BEESPACE_REMEMBER
  uint32_t reserved;       ///< Zero.
  double threshold_m;      ///< The threshold in metres, above zero. There is no default.
  double step_s;           ///< The time until the next advice, in seconds; 0 is 0.1.
  int32_t shape;           ///< BEESPACE_FREE_SPHERE, ...
  int32_t method;          ///< BEESPACE_CERTIFIED, ...
  double vertical_factor;  ///< Of an ellipsoid: its vertical semi-axis as a multiple of the other;
                           ///< 0 is 1.
  double vertical_m;       ///< Of a cylinder: half of its height, in metres; must be given.
  /// @brief The largest distance in metres between the true and the stated position of an agent, if
  /// the stated one moves as the agent was advised. It widens the threshold by twice this.
  double uncertainty_m;
  /// @brief No agent's centre shall come closer to an obstacle, or to the plane of a fence, than
  /// this, in metres. Must be given where there are any.
  double clearance_m;
  const beespace_obstacles* obstacles;  ///< The static obstacles; or NULL.
  /// @brief Half-spaces that no agent leaves: for each the direction inwards, of length 1. All
  /// places p with `direction . p >= offset` are inside. Or NULL.
  const beespace_points* fence_directions;
  const double* fence_offsets_m;  ///< The offset of each fence, in metres.
  /// @brief Agents that do not do as advised: where they are, in metres. All others give way, as if
  /// these flew straight on. Nothing is promised about them. Or NULL.
  const beespace_points* intruder_positions;
  const beespace_points* intruder_velocities;  ///< Their velocities, in metres per second.
  /// @brief How much more than the threshold is kept from each intruder, in metres; or NULL: 0.
  const double* intruder_margins_m;
  double intruder_horizon_s;  ///< How far to look ahead for intruders, in seconds; 0 is 10.
  /// @brief Agents of which only a growing ball is known: the centres in metres. Or NULL.
  const beespace_points* unknown_centers;
  const double* unknown_radii_m;  ///< The radius of each ball in metres as the step begins.
  /// @brief How fast each ball grows: the greatest speed of the agent, in metres per second; 0 of
  /// one that is known to hover.
  const double* unknown_growths_mps;
  /// @brief Which of the agents each of them is, -1 where it is none: its position is then ignored,
  /// and it gets no advice. Or NULL: none of them is.
  const int64_t* unknown_agents;
  double unknown_horizon_s;  ///< How far to look ahead for them, in seconds; 0 is 10.
  /// @brief The agents' own radii in metres, one each; or NULL: each is half of the threshold. What
  /// stays free between two is the threshold, or the sum of both radii where that is more.
  const double* radii_m;
  /// @brief How far each agent may be from its nominal place, in metres, one each; or NULL: 0.
  const double* tubes_m;
  /// @brief Where each agent may be from now on if nothing more is told to it, beyond its way to a
  /// stop: its *claim* is the hull of both. The places of all agents, agent after agent; or NULL.
  const beespace_points* claim_places;
  /// @brief Where the places of each agent begin: one number more than agents, from 0 to the number
  /// of places. NULL without places.
  const int64_t* claim_offsets;
  /// @brief 1 of an agent that gets no new advice: it stays within its claim, and others get all of
  /// the free space; else 0. Or NULL.
  const uint8_t* holds;
} beespace_advise_options;

/* ---- Advice --------------------------------------------------------------------------------- */

/// @brief How an advised velocity relates to the preferred one.
enum beespace_kinds_of_advice {
  BEESPACE_AS_PREFERRED = 0,  ///< The preferred one, or as near to it as the agent's limits allow.
  BEESPACE_DEFLECTED = 1,     ///< Another one, because of other agents or obstacles.
  BEESPACE_BRAKING = 2,       ///< It brakes as hard as it can: there is no better velocity.
  BEESPACE_WAITING = 3,       ///< It would like to fly, and stands: others are in its way.
  BEESPACE_NO_ADVICE = 4      ///< Its state is unknown, or cannot be used.
};

/// @brief What beespace_advice_findings() and beespace_guidance_findings() list.
enum beespace_finding_lists {
  /// @brief Agents whose ways to a stop (or claims) come closer than what must stay free: two
  /// agents, the gap between those, and when they are clear if both do as advised (infinite:
  /// never).
  BEESPACE_TOO_CLOSE = 0,
  /// @brief An agent, an obstacle that its way to a stop comes closer to than the clearance, and
  /// the gap.
  BEESPACE_NEAR_OBSTACLE = 1,
  BEESPACE_NEAR_FENCE = 2,  ///< The same of a fence; the gap is below zero outside.
  /// @brief An agent, an intruder that comes closer to it than the threshold, how close, and when
  /// that begins.
  BEESPACE_INTRUDER_CONFLICTS = 3,
  /// @brief An agent, an unknown one, the gap between way to a stop and ball, and for how long the
  /// threshold is surely kept.
  BEESPACE_NEAR_UNKNOWN = 4
};

/// @brief One list, in ascending order of (first, second). The arrays belong to what was asked, and
/// are valid until its next call or end; they are NULL where the list is empty.
typedef struct beespace_findings {
  size_t struct_size;         ///< sizeof(beespace_findings), set by the caller.
  int64_t count;              ///< How many there are.
  const int64_t* first;       ///< The agent.
  const int64_t* second;      ///< The other agent, or the obstacle, fence, ... by its index.
  const double* distances_m;  ///< The gap, in metres.
  const double* times_s;      ///< The time, in seconds; NULL of a list without one.
} beespace_findings;

/// @brief Keeps memory and threads from one step to the next.
typedef struct beespace_adviser beespace_adviser;
/// @brief Makes an adviser.
/// @return The adviser; NULL when there is no memory.
BEESPACE_C_API beespace_adviser* beespace_adviser_create(void);
/// @brief Frees an adviser, with its memory and its threads; no call may be using it.
/// @param adviser The adviser; NULL does nothing.
BEESPACE_C_API void beespace_adviser_free(beespace_adviser* adviser);

/// @brief Forgets all planes of one agent: its index is another one's from now on.
/// @param adviser The adviser; NULL does nothing.
/// @param agent The index of the agent; one that never was does nothing.
BEESPACE_C_API void beespace_adviser_forget(beespace_adviser* adviser, int64_t agent);

/// @brief Advice for all agents, in columns. Each call that is given it overwrites it. Arrays
/// belong to it, and are valid until its next call or end.
typedef struct beespace_advice beespace_advice;
/// @brief Makes an empty one.
/// @return The advice; NULL when there is no memory.
BEESPACE_C_API beespace_advice* beespace_advice_create(void);
/// @brief Frees advice and its arrays.
/// @param advice The advice; NULL does nothing.
BEESPACE_C_API void beespace_advice_free(beespace_advice* advice);

/// @brief Which velocity should each agent take in the next step?
///
/// A state that cannot be used is no error of the call: that agent gets no advice, is listed by
/// beespace_advice_refused(), and as it may be anywhere no other agent is certified. A microsecond
/// or two an agent, and a tenth for each other agent that it may meet.
///
/// @param adviser Keeps memory and threads for the next step; or NULL.
/// @param positions Where the agents are, in metres.
/// @param velocities Their velocities, in metres per second; as many.
/// @param preferred The velocities that they prefer; as many. Strides of 0 repeat one.
/// @param limits What they can do.
/// @param options The threshold, the step, and what else is there.
/// @param run Threads, and what ends the call early; or NULL.
/// @param[out] advice The advice; empty after an error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error:
///   - BEESPACE_INVALID_THRESHOLD;
///   - BEESPACE_INVALID_ARGUMENT: an option that makes no sense; arrays that differ in number;
///     limits that are given once for all, and make no sense;
///   - BEESPACE_TOO_MANY_POINTS, BEESPACE_STOPPED, BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code
beespace_advise(beespace_adviser* adviser, const beespace_points* positions,
                const beespace_points* velocities, const beespace_points* preferred,
                const beespace_limits* limits, const beespace_advise_options* options,
                const beespace_run* run, beespace_advice* advice, beespace_error* error);

/// @brief Says how many agents there are.
/// @param advice The advice.
/// @return The length of each column.
BEESPACE_C_API int64_t beespace_advice_size(const beespace_advice* advice);
/// @brief Gives the velocity of each agent at the end of the step.
/// @param advice The advice.
/// @return 3 * beespace_advice_size() numbers, interleaved, in metres per second; NULL of no agent.
///   Zero, and no advice, where the kind is BEESPACE_NO_ADVICE.
BEESPACE_C_API const double* beespace_advice_velocities(const beespace_advice* advice);
/// @brief Gives how each velocity relates to the preferred one: BEESPACE_AS_PREFERRED, ...
/// @param advice The advice.
/// @return beespace_advice_size() kinds; NULL of no agent.
BEESPACE_C_API const int32_t* beespace_advice_kinds(const beespace_advice* advice);
/// @brief Gives the all-clear of each agent: 1 where it keeps apart, and is clear of intruders and
/// of unknown agents; else 0.
/// @param advice The advice.
/// @return beespace_advice_size() flags; NULL of no agent.
BEESPACE_C_API const uint8_t* beespace_advice_certified(const beespace_advice* advice);
/// @brief Gives what is proven: as long as all do as advised, the agent keeps the threshold from
/// all others that are advised, and the clearance, for ever.
/// @param advice The advice.
/// @return As beespace_advice_certified().
BEESPACE_C_API const uint8_t* beespace_advice_keeps_apart(const beespace_advice* advice);
/// @brief Gives what is predicted: no intruder comes closer than the threshold within the horizon,
/// if it flies straight on and the agent as advised.
/// @param advice The advice.
/// @return As beespace_advice_certified().
BEESPACE_C_API const uint8_t* beespace_advice_clear_of_intruders(const beespace_advice* advice);
/// @brief Gives what is proven of unknown agents for the whole horizon: the threshold is kept,
/// wherever in their balls they are.
/// @param advice The advice.
/// @return As beespace_advice_certified().
BEESPACE_C_API const uint8_t* beespace_advice_clear_of_unknown(const beespace_advice* advice);
/// @brief Gives for how long that is proven, in seconds from the beginning of the step.
/// @param advice The advice.
/// @return beespace_advice_size() times, infinite where no ball grows; NULL of no agent.
BEESPACE_C_API const double* beespace_advice_clear_of_unknown_s(const beespace_advice* advice);

/// @brief Gives one list of what could not be certified, and why.
/// @param advice The advice.
/// @param what BEESPACE_TOO_CLOSE, ...
/// @param[out] findings The list.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK; or BEESPACE_INVALID_ARGUMENT: there is no such list, or a pointer is NULL.
BEESPACE_C_API beespace_code beespace_advice_findings(const beespace_advice* advice, int32_t what,
                                                      beespace_findings* findings,
                                                      beespace_error* error);

/// @brief What was refused, and what that means.
enum beespace_refused_kinds {
  /// @brief The state or the limits of an agent: no advice for it. It may be anywhere, so no other
  /// agent is certified, unless it is given as an unknown agent.
  BEESPACE_REFUSED_STATE = 0,
  BEESPACE_REFUSED_PREFERRED = 1,  ///< A preferred velocity: advised as if it preferred to stand.
  BEESPACE_REFUSED_INTRUDER = 2,   ///< An intruder: no agent is clear of intruders.
  BEESPACE_REFUSED_UNKNOWN = 3     ///< An unknown agent: no agent is clear of unknown ones.
};

/// @brief Says how many inputs could not be used.
/// @param advice The advice.
/// @return The number.
BEESPACE_C_API int64_t beespace_advice_refused_count(const beespace_advice* advice);
/// @brief Says what could not be used, and why.
/// @param advice The advice.
/// @param index Which, below beespace_advice_refused_count().
/// @param[out] why The code and the sentence; beespace_error::place and beespace_error::record say
///   which input.
/// @return BEESPACE_REFUSED_STATE, ...; -1 where there is no such one.
BEESPACE_C_API int32_t beespace_advice_refused(const beespace_advice* advice, int64_t index,
                                               beespace_error* why);

/// @brief The velocity of the fastest flight straight to a goal that stops there: the preferred
/// velocity of an agent with a destination.
/// @param positions Where the agents are, in metres.
/// @param goals Where they shall go; as many. Strides of 0 repeat one.
/// @param limits What they can do.
/// @param step_s The length of a step in seconds; 0 is 0.1.
/// @param[out] xyz The velocities, interleaved: room for 3 * count numbers. Unspecified after an
///   error.
/// @param[out] error What went wrong; or NULL.
/// @return BEESPACE_OK or the code of the error, with its agent in beespace_error::record:
///   BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN; or BEESPACE_INVALID_ARGUMENT.
BEESPACE_C_API beespace_code beespace_velocity_to_goal(const beespace_points* positions,
                                                       const beespace_points* goals,
                                                       const beespace_limits* limits, double step_s,
                                                       double* xyz, beespace_error* error);

#ifdef __cplusplus
}
#endif

#endif
