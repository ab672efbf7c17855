/// @file
/// @brief Which velocity should each agent take next, so that all keep the threshold?
///
/// Given where all agents are, how fast they fly and which velocity each prefers, advise() gives
/// each agent the velocity for the next step that is closest to its preferred one among those that
/// are *certified*: as long as all agents do as advised, no two come closer than the threshold, in
/// this step and for ever after, because each can always brake to a stop clear of all others.
/// Neither does any agent come closer to an obstacle than the clearance. The proof and its
/// conditions are in docs/prevention.md.
///
/// One bad number never stops the advice: an agent whose state cannot be used is named
/// (Advised::refused) and gets no advice, and the others get theirs, certified as far as that is
/// true without it.
///
/// Values too small for the motion domain (below #beespace::kSmallestInMotion, see mover.hpp) count
/// as zero where they enter, which the certificate allows for.
///
/// The model of motion: in a step of AdviseOptions::step_s an agent changes its velocity evenly
/// from the old one to the new one, within its greatest acceleration; an agent without such a limit
/// flies with the new velocity from the start. Units: metres and seconds, in one Cartesian frame.
///
/// Source: docs/prevention.md for the certificate; as in optimal reciprocal collision avoidance
/// (ORCA: van den Berg, Guy, Lin, Manocha: Reciprocal n-body collision avoidance, 2011),
/// half-spaces bound the velocities.
#pragma once

#include <beespace/crew.hpp>
#include <beespace/export.hpp>
#include <beespace/lifetimebound.hpp>
#include <beespace/mover.hpp>
#include <beespace/not_given.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/pairs.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/separation.hpp>

#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace beespace {

/// @brief The limits of an agent.
struct FlightLimits {
  double max_speed_mps = 10.0;  ///< The greatest speed in metres per second; zero or more.
  /// @brief The greatest acceleration in metres per second squared; above zero. Infinite:
  /// velocities change at once.
  double max_acceleration_mps2 = std::numeric_limits<double>::infinity();

  friend constexpr bool operator==(const FlightLimits&, const FlightLimits&) = default;
};

/// @brief The velocity of the fastest flight straight to a goal that stops there: the preferred
/// velocity of an agent with a destination. Zero within a nanometre of it.
///
/// Complexity: constant. Thread safety: no state is kept.
///
/// @param position Where the agent is, in metres.
/// @param goal Where it shall go, in metres.
/// @param limits What it can do.
/// @param step_s The length of a step in seconds; above zero.
/// @return The velocity in metres per second; or an error:
///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a position or goal that is not of the
///     motion domain (see mover.hpp);
///   - ErrorCode::kInvalidArgument: a step that is not above zero, or limits as Adviser::advise.
BEESPACE_API Result<Velocity> velocity_to_goal(const Point& position, const Point& goal,
                                               const FlightLimits& limits, double step_s);

/// @brief The method that keeps agents apart.
enum class AdviseMethod : std::uint8_t {
  /// @brief The certified method of beespace.
  kCertified,
  /// @brief Optimal reciprocal collision avoidance (ORCA), in space; to compare with. Like kMvp it
  /// promises nothing, certifies no agent, and ignores obstacles and intruders.
  kOrca,
  /// @brief Modified voltage potential (MVP): sideways, out of each conflict ahead; to compare
  /// with.
  kMvp,
};

/// @brief An agent whose position is not known, only a ball that contains it: it was not heard of
/// for a while, or is not where its reports say.
///
/// t seconds after the step begins, the ball has grown by `growth_mps` times t. Of an agent that is
/// known to hover, the growth is zero.
struct UnknownAgent {
  Point center;           ///< The centre of the ball, in metres.
  double radius_m = 0.0;  ///< The radius in metres as the step begins; zero or more.
  double growth_mps =
      0.0;  ///< The greatest speed of the agent, in metres per second; zero or more.

  /// @brief The index of the agent among the movers, if it is one of them. Its mover is then
  /// ignored, and it gets no advice.
  std::optional<PointId> agent = {};

  friend constexpr bool operator==(const UnknownAgent&, const UnknownAgent&) = default;
};

namespace detail {

// A span in options, which outlive the statement that fills them: of a temporary container it does
// not compile.
template <class T>
class KeptSpan : public std::span<const T> {
 public:
  constexpr KeptSpan() = default;
  template <class Range>
  requires std::convertible_to<const Range&, std::span<const T>>
  constexpr KeptSpan(  // NOLINT(google-explicit-constructor): a span
      const Range& range BEESPACE_LIFETIMEBOUND)
      : std::span<const T>(range) {}
  template <Container Range>
  requires std::convertible_to<const Range&, std::span<const T>> KeptSpan(const Range&& range)
  = delete;
};

}  // namespace detail

/// @brief Where one agent may be from now on if nothing more is told to it, beyond its stopping
/// segment; and how large it is.
///
/// The *claim* of an agent is the convex hull of its stopping segment and of `places`: all nominal
/// places where it can be, on every branch that it may be on. It is never farther than `tube_m`
/// from its nominal place.
///
/// Ownership: `places` refers to the caller's memory.
struct Claim {
  std::span<const Point> places = {};  ///< In metres; may be empty.
  double tube_m = 0.0;                 ///< The radius of its tube in metres; zero or more.
  double radius_m = 0.0;               ///< Its own radius in metres; zero or more.
  /// @brief Whether it gets no new advice: it stays within its claim, and its advice is
  /// AdviceKind::kBraking. Others get all of the free space.
  bool holds = false;
};

/// @brief A half-space that agents do not leave: the side of a plane to which `inward` points.
struct Fence {
  Point inward = {0.0, 0.0, 1.0};  ///< The direction inwards, of length 1.
  double offset_m = 0.0;  ///< All places p with inward . p >= offset are inside, in metres.

  friend constexpr bool operator==(const Fence&, const Fence&) = default;
};

/// @brief Remembers the normals of the planes between agents from one call to the next.
///
/// A plane that certified a pair does so again in the next step, whatever direction is found anew.
/// Agents are known by their indices, which must stay the same. Nothing is remembered of an agent
/// that a call refuses, or that is unknown in it, nor after a call that fails.
///
/// Ownership: owns its memory. Thread safety: none.
class BEESPACE_API PlaneMemory {
 public:
  /// @brief Remembers nothing.
  PlaneMemory();
  PlaneMemory(const PlaneMemory&) = delete;
  PlaneMemory& operator=(const PlaneMemory&) = delete;
  /// @brief Takes over what is remembered.
  PlaneMemory(PlaneMemory&&) noexcept;
  /// @brief Takes over what is remembered.
  /// @return This.
  PlaneMemory& operator=(PlaneMemory&&) noexcept;
  /// @brief Frees its memory.
  ~PlaneMemory();

  /// @brief Forgets all planes of one agent: its index is another one's from now on.
  /// @param agent The index.
  void forget(PointId agent);

  class State;  ///< Internal.
  /// @brief Internal.
  /// @return What is remembered.
  [[nodiscard]] State& state() const { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

/// @brief What advice needs to know.
///
/// Ownership: `obstacles`, `claims`, `fences`, `planes`, `intruders` and `unknown` refer to the
/// caller's memory, which must outlive the options.
struct AdviseOptions {
  /// @brief The threshold in metres: no two agents shall come closer than this. Must be given:
  /// there is no default.
  double threshold_m = kNotGiven;

  /// @brief What must stay free around each agent: the shape whose horizontal semi-axis is the
  /// threshold.
  Separation separation = {};

  /// @brief The time in seconds until the next advice; above zero. All agents begin the step at the
  /// same time.
  double step_s = 0.1;

  /// @brief The claims of all agents, one for each; or none: each claims its stopping segment. The
  /// movers are then the states from which each would depart as it is advised.
  detail::KeptSpan<Claim> claims = {};

  /// @brief The planes of the call before, and afterwards those of this one; null: they are found
  /// anew. Should be given where there are claims.
  PlaneMemory* planes = nullptr;

  /// @brief The half-spaces that no agent leaves; the clearance is kept from their planes.
  detail::KeptSpan<Fence> fences = {};

  /// @brief Whether all agents move in one horizontal plane: robots on a floor, ships. Velocities
  /// are then horizontal, vertical components of preferred velocities count as zero, and every
  /// shape is a circle. An agent whose height (or that of a place of its claim) is not that of most
  /// agents, or whose vertical velocity is not zero, is refused (Advised::refused).
  bool planar = false;

  /// @brief The largest distance in metres between the true and the stated position of an agent, if
  /// the stated one moves as the agent was advised: positions are those to which the advice before
  /// led, not measured anew (see docs/prevention.md). It widens the threshold by twice this, and
  /// the clearance by once.
  double uncertainty_m = 0.0;

  /// @brief The static obstacles; null for none.
  const ObstacleMap* obstacles = nullptr;
  /// @brief The clearance in metres: no agent's centre shall come closer to an obstacle, or to the
  /// plane of a fence, than this. Above zero; must be given where there are obstacles or fences. A
  /// tube is added to it, and Claim::radius_m is not: give the largest radius and the distance that
  /// shall be left.
  double clearance_m = kNotGiven;

  /// @brief Agents that fly among the others and do not do as advised. All others give way to them,
  /// as if they flew straight on for `intruder_horizon_s`. Nothing is promised about them.
  MoversView intruders = {};
  /// @brief How much more than the threshold is kept from each intruder, in metres, zero or more:
  /// its radius, and what is uncertain of it. One for each intruder; or none.
  detail::KeptSpan<double> intruder_margins_m = {};
  /// @brief How far to look ahead for intruders, in seconds; above zero.
  double intruder_horizon_s = 10.0;

  /// @brief Agents of which only a growing ball is known. All others keep clear of what the balls
  /// are after `unknown_horizon_s`, as far as they can. For what is promised see
  /// Advice::clear_of_unknown_s.
  detail::KeptSpan<UnknownAgent> unknown = {};
  /// @brief How far to look ahead for unknown agents, in seconds; above zero.
  double unknown_horizon_s = 10.0;

  /// @brief The method that keeps agents apart.
  AdviseMethod method = AdviseMethod::kCertified;

  /// @brief How many threads may work, the calling one included; 0 means one per processor. The
  /// answer is the same for every number.
  unsigned threads = 1;

  /// @brief When a stop is requested, the call ends soon, with ErrorCode::kStopped and no advice.
  std::stop_token stop = {};
};

/// @brief How an advised velocity relates to the preferred one.
enum class AdviceKind : std::uint8_t {
  kAsPreferred,  ///< The preferred velocity, or as near to it as the limits of the agent allow.
  kDeflected,    ///< Another velocity, because of other agents or obstacles.
  kBraking,      ///< The agent brakes as hard as it can: there is no better velocity.
  kWaiting,      ///< It would like to fly, and stands (or nearly so): others are in its way.
  kNone,         ///< No advice: its state is unknown, or cannot be used (see Advised::refused).
};

/// @brief The advice for one agent.
struct Advice {
  /// @brief The velocity at the end of the step, in metres per second; of an agent without a limit
  /// of acceleration, for all of the step. Of AdviceKind::kNone it is zero, and no advice.
  Velocity velocity;
  /// @brief How the velocity relates to the preferred one.
  AdviceKind kind = AdviceKind::kNone;

  /// @brief The all-clear: `keeps_apart`, `clear_of_intruders` and `clear_of_unknown` together.
  /// What is proven of it holds for ever, or for `clear_of_unknown_s` where that is finite.
  bool certified = false;

  /// @brief Proven: as long as all agents do as advised, this one keeps the threshold from all
  /// others that are advised, and the clearance from obstacles, for ever. False where it is closer
  /// already, or could not brake in time: see Advised::too_close and Advised::near_obstacle.
  bool keeps_apart = false;

  /// @brief Predicted, not proven: no intruder comes closer than the threshold within the horizon,
  /// if it flies straight on and the agent as advised. See Advised::intruder_conflicts. False for
  /// all agents where an intruder cannot be used (Advised::refused): it may be anywhere.
  bool clear_of_intruders = false;

  /// @brief Proven: as long as this agent does as advised, it keeps the threshold from all unknown
  /// agents for so many seconds from the beginning of the step, wherever in their balls they are,
  /// and however often it is advised anew.
  ///
  /// Infinite where there are no unknown agents, or where their balls do not grow; zero where an
  /// agent of which no ball is known (Advised::refused) may be anywhere.
  double clear_of_unknown_s = 0.0;
  /// @brief The same for the whole AdviseOptions::unknown_horizon_s.
  bool clear_of_unknown = false;

  friend constexpr bool operator==(const Advice&, const Advice&) = default;
};

/// @brief Two agents whose stopping segments (or claims) come closer than what must stay free.
///
/// A stopping segment is the way of an agent that brakes to a stop. The two do not come closer than
/// those segments are, and are advised to separate as fast as they can.
struct TooClose {
  Pair pair;  ///< The two agents.
  double gap_m =
      0.0;  ///< Between the two segments, in metres; about zero or below where they cross. Of
            ///< claims: between both along the plane's normal, less their tubes.
  /// @brief When the two are the threshold apart, in seconds, if both go on as advised; infinite:
  /// never. Zero for two that are too fast to stop in time, and still far enough apart.
  double clear_s = 0.0;

  friend constexpr bool operator==(const TooClose&, const TooClose&) = default;
};

/// @brief An agent whose stopping segment comes closer to an obstacle than the clearance.
struct NearObstacle {
  PointId agent = 0;         ///< The index of the agent.
  std::size_t obstacle = 0;  ///< The index of the obstacle.
  double gap_m = 0.0;        ///< Between segment and obstacle, in metres.

  friend constexpr bool operator==(const NearObstacle&, const NearObstacle&) = default;
};

/// @brief An agent whose claim comes closer to the plane of a fence than the clearance, or leaves
/// it.
struct NearFence {
  PointId agent = 0;      ///< The index of the agent.
  std::size_t fence = 0;  ///< The index of the fence.
  double gap_m = 0.0;     ///< Between claim and plane, in metres; below zero outside.

  friend constexpr bool operator==(const NearFence&, const NearFence&) = default;
};

/// @brief An agent to which an intruder comes closer than the threshold, if both fly straight on,
/// the agent as advised.
struct IntruderConflict {
  PointId agent = 0;         ///< The index of the agent.
  std::size_t intruder = 0;  ///< The index of the intruder.
  double begins_s = 0.0;     ///< When the conflict begins at the earliest, in seconds.
  double closest_m = 0.0;    ///< They stay so far apart, in metres, and hardly come less close.

  friend constexpr bool operator==(const IntruderConflict&, const IntruderConflict&) = default;
};

/// @brief An agent whose stopping segment comes closer than the threshold to what the ball of an
/// unknown agent may be within the horizon.
struct NearUnknown {
  PointId agent = 0;        ///< The index of the agent.
  std::size_t unknown = 0;  ///< The index of the unknown agent in AdviseOptions::unknown.
  double gap_m = 0.0;       ///< Between segment and ball as the step begins, in metres.
  double clear_s = 0.0;     ///< For so many seconds it surely keeps the threshold.

  friend constexpr bool operator==(const NearUnknown&, const NearUnknown&) = default;
};

/// @brief Which input cannot be used, and what that means.
enum class RefusedKind : std::uint8_t {
  /// @brief The position, velocity or limits of an agent: no advice for it. It may be anywhere, so
  /// no other agent is clear of it, unless AdviseOptions::unknown gives a ball that contains it.
  kState,
  /// @brief The preferred velocity of an agent: it is advised as if it preferred to stand.
  kPreferred,
  kIntruder,  ///< An intruder: no agent is clear of it.
  kUnknown,   ///< An unknown agent: no agent is clear of it.
};

/// @brief An input that cannot be used.
struct Refused {
  RefusedKind kind = RefusedKind::kState;  ///< Which input.
  std::size_t index = 0;  ///< The index of the agent, the intruder or the unknown agent.
  /// @brief What is wrong: ErrorCode::kNotFinite, ErrorCode::kOutsideDomain or
  /// ErrorCode::kInvalidArgument.
  Error error;
};

/// @brief The advice for all agents, and what could not be certified.
struct Advised {
  std::vector<Advice> advice;                        ///< The advice for each agent.
  std::vector<TooClose> too_close;                   ///< In ascending order of the pairs.
  std::vector<NearObstacle> near_obstacle;           ///< In ascending order of (agent, obstacle).
  std::vector<NearFence> near_fence;                 ///< In ascending order of (agent, fence).
  std::vector<IntruderConflict> intruder_conflicts;  ///< In ascending order of (agent, intruder).
  std::vector<NearUnknown> near_unknown;             ///< In ascending order of (agent, unknown).
  std::vector<Refused> refused;  ///< Unknown agents, agents, intruders; each in order of index.

  /// @brief Empties all; keeps the memory.
  void clear() {
    advice.clear();
    too_close.clear();
    near_obstacle.clear();
    near_fence.clear();
    intruder_conflicts.clear();
    near_unknown.clear();
    refused.clear();
  }
};

/// @brief What an agent must know of itself, and of another one that it may meet, to advise itself
/// as Adviser::advise advises all: the input of one round.
///
/// Ownership: `claim` is the caller's.
struct AgentInRound {
  PointId id = 0;                ///< Its index in the call for all.
  Mover mover;                   ///< Its state, in metres and metres per second.
  Velocity preferred;            ///< Its preferred velocity in metres per second.
  FlightLimits limits;           ///< What it can do.
  const Claim* claim = nullptr;  ///< Its claim; null for all where the round has no claims.
  /// @brief Whether it is too close to any other agent (it is in a pair of Advised::too_close of
  /// this round). Others make room for such an agent.
  bool too_close = false;
};

/// @brief Gives advice again and again: keeps its working memory and its threads between calls.
///
/// Ownership: an Adviser owns its memory and threads; views are read during a call and not kept.
/// Thread safety: none; use one Adviser per thread. A moved-from Adviser can only be destroyed or
/// assigned to.
class BEESPACE_API Adviser {
 public:
  /// @brief Makes an adviser with threads of its own.
  Adviser();
  /// @brief Works with the threads of `crew`, all of which work on every call:
  /// AdviseOptions::threads is ignored.
  /// @param crew The threads; must outlive the Adviser.
  explicit Adviser(Crew& crew BEESPACE_LIFETIMEBOUND);
  Adviser(const Adviser&) = delete;
  Adviser& operator=(const Adviser&) = delete;
  /// @brief Takes over memory and threads.
  Adviser(Adviser&&) noexcept;
  /// @brief Takes over memory and threads.
  /// @return This.
  Adviser& operator=(Adviser&&) noexcept;
  /// @brief Gives back memory and threads.
  ~Adviser();

  /// @brief Advises all agents for one step.
  ///
  /// The answer depends on the arguments alone: not on the order of calls, nor on threads.
  ///
  /// Complexity: a microsecond or two per agent, and a tenth for each other agent that it may meet;
  /// of n agents at one position that is n squared, in time and in memory.
  ///
  /// @param movers The agents, in metres and metres per second.
  /// @param preferred The preferred velocity of each agent, in metres per second.
  /// @param limits The limits of each agent, or one for all.
  /// @param options The threshold, the step, obstacles, intruders and unknown agents.
  /// @param[out] advised The advice; overwritten, and empty after an error. Input of one agent or
  ///   intruder alone that cannot be used is no error of the call: see Advised::refused.
  /// @return Success, or an error:
  ///   - ErrorCode::kInvalidThreshold: a threshold that is not given, or is no number above zero of
  ///     the motion domain (see mover.hpp);
  ///   - ErrorCode::kInvalidArgument: a step, clearance or horizon that is not above zero, a
  ///   negative
  ///     uncertainty, a value that is no AdviseMethod, arrays of the wrong length, an unknown agent
  ///     that is said to be a mover and is none; and for limits that are given once for all, a
  ///     greatest speed that is negative or infinite, or a greatest acceleration that is not above
  ///     zero;
  ///   - ErrorCode::kTooManyPoints: more agents than ids;
  ///   - ErrorCode::kStopped: a stop was requested (AdviseOptions::stop).
  Status advise(const MoversView& movers, std::span<const Velocity> preferred,
                std::span<const FlightLimits> limits, const AdviseOptions& options,
                Advised& advised);

  /// @brief Advises one agent that knows the others that it may meet: on board.
  ///
  /// The answer is that of the call for all, bit by bit, if `others` has all agents whose claims
  /// may come within the threshold (with tubes and radii) of its own in the step, or within
  /// 1.6 times as much; further ones change nothing. AdviseOptions::planes, where used, must be the
  /// agent's own, and must have been used in the same rounds: it is known by ids here.
  ///
  /// Complexity: as Adviser::advise for one agent. AdviseOptions::claims, `threads`, `stop` and
  /// `method` are not used; AdviseOptions::unknown names agents by their ids.
  ///
  /// @param agent The agent.
  /// @param others The others, in any order.
  /// @param options As of the call for all.
  /// @param[out] advice The advice; none (AdviceKind::kNone) after an error.
  /// @return Success, or an error: as Adviser::advise; ErrorCode::kInvalidArgument where two have
  ///   one id, or some have claims and others none; and what the call for all would refuse
  ///   (Advised::refused) about the agent itself.
  Status advise_one(const AgentInRound& agent, std::span<const AgentInRound> others,
                    const AdviseOptions& options, Advice& advice);

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// @brief Advises all agents for one step, as Adviser::advise, once.
/// @param movers The agents, in metres and metres per second.
/// @param preferred The preferred velocity of each agent, in metres per second.
/// @param limits The limits of each agent, or one for all.
/// @param options The threshold, the step, obstacles, intruders and unknown agents.
/// @return The advice, or an error of Adviser::advise.
BEESPACE_API Result<Advised> advise(const MoversView& movers, std::span<const Velocity> preferred,
                                    std::span<const FlightLimits> limits,
                                    const AdviseOptions& options);

}  // namespace beespace
