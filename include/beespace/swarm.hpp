/// @file
/// @brief A live swarm: position reports go in, events come out.
///
/// What has happened is derived from reports alone: between two reports that are no more than
/// SwarmOptions::max_age_s apart an agent moves in a straight line, as in track.hpp; the time
/// between two that are farther apart is unknown, as in a gap of a recording; and an agent that is
/// heard of once is there at that instant. So the events *entered*, *closest passed*, *left* and
/// *lost* are exact, and the same however often Swarm::advance is called, where reports come in the
/// order of their times (an agent that is first heard of late has missed what all others know by
/// then: SwarmCounts::missed_s). They come as soon as both agents are known up to then. What is
/// about to happen, *predicted*, is derived from the last reports and velocities, as by
/// predict_conflicts; it comes again for a pair only after the pair has been out of danger.
///
/// Silence is not absence. An agent that has not been heard of for `max_age_s` is *stale*: it is
/// somewhere, and stays known until it is removed. A pair that had entered and of which one agent
/// falls silent is *lost*, which is neither left nor a distance that is kept. Each *entered* is
/// followed by one of *left*, *lost* and *ended* of its pair. When the stale agent is *heard* of
/// again, what is true then is reported anew: *entered*, if the two are in conflict at that
/// instant. With SwarmOptions::max_speed_mps, a stale agent is somewhere in a growing ball around
/// the position where it was last heard of, and any other agent in one around its own last report:
/// where these come closer than the threshold, before one of the two is heard of, a conflict is
/// *possible*. That is reported once for a pair until one of the two is heard of again after a
/// silence, or removed, and is true until then.
///
/// Hysteresis: a pair that has entered (come closer than the threshold) has left only when it is
/// farther apart than the leave threshold, so that events do not alternate at the threshold.
///
/// Values of reports that are too small for exact comparison are zero to a swarm (see mover.hpp).
///
/// Units: metres and seconds, in one Cartesian frame. Ids are the caller's own numbers (AgentId).
#pragma once

#include <beespace/agent_id.hpp>
#include <beespace/crew.hpp>
#include <beespace/export.hpp>
#include <beespace/lifetimebound.hpp>
#include <beespace/mover.hpp>
#include <beespace/not_given.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace beespace {

/// @brief What a live swarm needs to know. Plain values; nothing is referred to.
struct SwarmOptions {
  /// @brief The threshold in metres, as ConflictOptions::threshold_m. Must be given: there is no
  /// default.
  double threshold_m = kNotGiven;
  /// @brief The vertical threshold in metres, or in the unit of `height_unit_m`, as
  /// ConflictOptions::vertical_m.
  std::optional<double> vertical_m = {};

  /// @brief With `vertical_m`: heights are those that reports give apart from their positions
  /// (PositionReport::height_m), not z (as in Track::heights_m).
  bool heights_apart = false;

  /// @brief Thresholds of leaving are those of entering times this: 1 or more.
  double leave_factor = 1.1;

  /// @brief How far to look ahead, in seconds. 0: no predictions.
  double horizon_s = 10.0;

  /// @brief An agent that has not been heard of for longer than this, in seconds, is stale: unknown
  /// until it is heard of again.
  double max_age_s = 5.0;

  /// @brief How many threads may work, the calling one included; 0 means one per processor. The
  /// events are the same for every number.
  unsigned threads = 1;

  /// @brief The length in metres of one unit of heights that are kept apart, where these are not
  /// metres: 0.3048 for feet. `vertical_m` and climb rates are then in that unit too, and compared
  /// with the heights as they are, exactly. Reported distances are in metres in any case.
  double height_unit_m = 1.0;

  /// @brief The greatest speed of all agents in metres per second, heights included. If it is
  /// given, possible conflicts of a stale agent come as EventKind::kPossible; without it these are
  /// unknown.
  std::optional<double> max_speed_mps = {};

  /// @brief How many agents are known at a time, stale ones included. Reports of further agents are
  /// refused.
  std::size_t max_agents = 1'000'000;

  /// @brief How many pairs are followed at a time: at most this many in conflict, this many
  /// predicted, and this many possible. Where there are more, the closest are followed. A pair
  /// takes up to some 700 bytes.
  std::size_t max_pairs = 500'000;
};

/// @brief One message: where an agent was at a time, and how fast it was, where that is known.
struct PositionReport {
  AgentId id = 0;                         ///< The caller's number of the agent.
  double time_s = 0.0;                    ///< The time in seconds.
  Point position;                         ///< The position in metres.
  std::optional<Velocity> velocity = {};  ///< In metres per second; absent: that of the last two
                                          ///< reports.

  /// @brief The height, with SwarmOptions::heights_apart; in metres or SwarmOptions::height_unit_m.
  double height_m = 0.0;
  /// @brief The climb rate, in the unit of heights per second; used where there is a velocity.
  double climb_mps = 0.0;
};

/// @brief The kinds of events, in the order in which events of one instant are reported.
enum class EventKind : std::uint8_t {
  kPredicted,      ///< A conflict lies ahead, or is there now.
  kPossible,       ///< A stale agent may be in conflict with another one, at `max_speed_mps`.
  kHeard,          ///< A stale agent has been heard of again.
  kEntered,        ///< Two agents have come closer than the threshold.
  kClosestPassed,  ///< The closest instant has passed: the distance of the two grows again.
  kLeft,           ///< Farther apart than the leave threshold, or one of the two was removed.
  kStale,          ///< An agent has not been heard of for `max_age_s`.
  kLost,           ///< One of two that had entered has fallen silent: from then on it is unknown.
  kEnded,          ///< Of finish(): two that had entered, when nothing more was heard.
  kOverloaded,     ///< A bound was reached: since the last call of advance(), something was left
                   ///< out.
};
/// @brief How many kinds of events there are.
inline constexpr std::size_t kEventKinds = static_cast<std::size_t>(EventKind::kOverloaded) + 1;

/// @brief The bound that was reached where a swarm is overloaded.
enum class SwarmBound : std::uint8_t {
  kNone,    ///< None.
  kAgents,  ///< `max_agents`: reports of other agents were refused, the first one that of `first`.
  kPairs,   ///< `max_pairs`, of pairs in conflict.
  kPredicted,  ///< `max_pairs`, of predicted pairs.
  kPossible,   ///< `max_pairs`, of possible conflicts.
};
/// @brief How many bounds there are, kNone included.
inline constexpr std::size_t kSwarmBounds = static_cast<std::size_t>(SwarmBound::kPossible) + 1;

/// @brief An event: what happened to which agents, and when.
struct SwarmEvent {
  /// @brief What happened.
  EventKind kind = EventKind::kPredicted;
  /// @brief When it happened, in seconds. Of a prediction: when the conflict begins; of kStale:
  /// when the agent was last heard of; of kLost and kEnded: until when both are known; of
  /// kPossible: since when it may be so, from where both were last heard of; of kOverloaded: the
  /// time that advance() was asked about.
  double time_s = 0.0;
  AgentId first = 0;   ///< One agent; below `second`.
  AgentId second = 0;  ///< The other; of kStale, kHeard and kOverloaded, the same as `first`. Both
                       ///< mean nothing where a bound of pairs was reached.
  /// @brief The distance of the two at that time, in metres. Of a prediction: when they are
  /// closest; of kPossible: where they were last heard of; of kOverloaded: from what distance on
  /// pairs were left out.
  double distance_m = 0.0;
  /// @brief When the two are closest, in seconds: in the future of a prediction, otherwise so far.
  /// Of events of no pair, as `time_s`.
  double closest_s = 0.0;
  /// @brief Of kHeard, kStale, kLost and kPossible: since when the agent has been silent, in
  /// seconds; of two silent ones, that with the longer silence.
  double since_s = 0.0;
  std::uint64_t count = 0;  ///< Of kOverloaded: how many were left out, at least; 0: not known.
  SwarmBound bound = SwarmBound::kNone;  ///< Of kOverloaded: the bound.
  /// @brief Of kPredicted: `closest_s` is where the horizon ends, and the two come closer after it.
  bool closing = false;

  friend constexpr bool operator==(const SwarmEvent&, const SwarmEvent&) = default;
};

/// @brief What became of the reports.
struct SwarmCounts {
  std::uint64_t taken = 0;     ///< Reports that were used.
  std::uint64_t repeated = 0;  ///< The same time and position again: left out.
  std::uint64_t late = 0;      ///< Before a report of the same agent that was used: left out.
  std::uint64_t agents = 0;    ///< Agents that are known and not stale, now.
  std::uint64_t stale = 0;     ///< Agents that are stale, now.
  std::uint64_t refused = 0;   ///< Of an agent beyond `max_agents`: left out.
  std::uint64_t contrary = 0;  ///< The time of one of the last two again, elsewhere: left out.
  /// @brief Agents that are known from one report only: where they were at that instant, no more.
  std::uint64_t heard_once = 0;
  /// @brief Pairs of which a conflict was predicted that has neither begun nor been averted, now.
  std::uint64_t predicted = 0;
  /// @brief For how long agents have been unknown in all, in seconds, removed ones included, where
  /// they have been heard of again.
  double unknown_s = 0.0;
  /// @brief How far the first reports of agents, or their first after a silence, were before what
  /// was still known of the others, in seconds in all: what happened in these times is not found.
  double missed_s = 0.0;
};

/// @brief A known agent, and where it would be.
struct LiveMover {
  AgentId id = 0;  ///< The caller's number of the agent.
  /// @brief Extrapolated in a straight line from its last report, where it `moves`; otherwise it
  /// stands where it was last heard of. That does not say that it stands: it may have gone anywhere
  /// since `heard_s`.
  Mover mover;
  double heard_s = 0.0;  ///< The time of its last report, in seconds.
  Point heard_at;        ///< The position of its last report, in metres.
  bool stale = false;    ///< Whether it was stale when advance() was last called.
  bool moves = false;    ///< Whether it is not stale, and its velocity is known: given, or of two
                         ///< reports.

  friend constexpr bool operator==(const LiveMover&, const LiveMover&) = default;
};

/// @brief An agent that was or is unknown for a time: between two reports more than `max_age_s`
/// apart, or since its last one where it is stale.
struct Silence {
  AgentId id = 0;                      ///< The caller's number of the agent.
  double unknown_s = 0.0;              ///< How long in all, until now, in seconds.
  std::optional<double> since_s = {};  ///< Since when, of the silence that has not ended.

  friend constexpr bool operator==(const Silence&, const Silence&) = default;
};

/// @brief A live swarm: takes position reports, reports events.
///
/// Ownership: owns its memory. Memory: a few hundred bytes for each agent until it is removed, of
/// which there are at most SwarmOptions::max_agents; up to some 700 bytes for each followed pair;
/// and the reports since the agent that was last heard of longest ago, which
/// SwarmOptions::max_age_s bounds. Where a bound leaves something out, advance() says so
/// (EventKind::kOverloaded), and what it leaves out are the pairs farthest apart. A pair in
/// conflict that makes room for closer ones is *lost*.
///
/// Complexity: linear in the agents and their reports, and in the pairs up to a few times
/// `max_pairs`; with `max_speed_mps`, stale agents times all agents too, as long as their balls
/// have not reached all.
///
/// A call cannot be stopped half-way: the next one would not know what has been reported. The
/// bounds limit how long one takes.
///
/// Thread safety: none. A moved-from Swarm can only be destroyed or assigned to.
class BEESPACE_API Swarm {
 public:
  /// @brief Makes a swarm without agents.
  /// @param options The threshold and the bounds. If they make no sense, each call returns the
  /// error.
  explicit Swarm(const SwarmOptions& options);
  /// @brief Makes a swarm without agents that works with the threads of `crew`: all of them work on
  /// advance(), finish() and begin_anew(), and SwarmOptions::threads is ignored.
  /// @param options The threshold and the bounds.
  /// @param crew The threads; must outlive the Swarm.
  Swarm(const SwarmOptions& options, Crew& crew BEESPACE_LIFETIMEBOUND);
  Swarm(const Swarm&) = delete;
  Swarm& operator=(const Swarm&) = delete;
  /// @brief Takes over the agents.
  Swarm(Swarm&&) noexcept;
  /// @brief Takes over the agents.
  /// @return This.
  Swarm& operator=(Swarm&&) noexcept;
  /// @brief Frees its memory.
  ~Swarm();

  /// @brief Takes a report, in any order of agents; of one agent, late, repeated and contrary
  /// ones are counted and left out.
  /// @param report The report, in metres and seconds.
  /// @return Success; or an error with the agent in ErrorLocation::record, in which case the report
  ///   is left out, and all others count:
  ///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a value that is too large for the motion
  ///     domain (see mover.hpp);
  ///   - ErrorCode::kTooManyPoints: an agent beyond SwarmOptions::max_agents;
  ///   - the errors of the options.
  Status update(const PositionReport& report);

  /// @brief Removes an agent that is no longer there.
  ///
  /// Nothing of it is kept once the others have been heard of as late as it was, or for
  /// `max_age_s`; unknown agents do not delay that. Pairs of it that had entered have *left*.
  ///
  /// @param id The caller's number of the agent.
  void remove(AgentId id);

  /// @brief Breaks the line of an agent: its next report does not go on from those before it (its
  /// clock has stepped, or reports in between cannot be used).
  ///
  /// The agent is stale from its last report on, until it is heard of again.
  ///
  /// @param id The caller's number of the agent.
  void lose(AgentId id);

  /// @brief Reports what has happened since the last call, and what is predicted.
  /// @param now_s The time in seconds, by which the age of reports is judged.
  /// @return The events, in ascending order of (time, kind, first, second); or an error:
  ///   - ErrorCode::kTimeOrder: `now_s` is before that of the last call;
  ///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: `now_s` is not in the motion domain;
  ///   - ErrorCode::kInvalidThreshold, ErrorCode::kInvalidArgument: the options.
  Result<std::vector<SwarmEvent>> advance(double now_s);
  /// @brief The same into the caller's vector.
  ///
  /// After the numbers of agents and pairs have reached their peaks, advance(), update() and
  /// movers() into a vector allocate nothing, as long as no agent comes or goes and none is stale.
  ///
  /// @param now_s The time in seconds.
  /// @param[out] events The events; overwritten, and empty after an error.
  /// @return Success, or the same errors.
  Status advance(double now_s, std::vector<SwarmEvent>& events);

  /// @brief The last advance(): nothing more will be heard.
  ///
  /// Pairs that have entered and neither left nor been lost have *ended*. No agent is known
  /// afterwards, and times may begin anew; counts go on.
  ///
  /// @param now_s The time in seconds.
  /// @return The events, or an error, as advance().
  Result<std::vector<SwarmEvent>> finish(double now_s);

  /// @brief As finish(), but all agents stay known: times begin anew, and what was `now_s` is
  /// `then_s` from now on.
  ///
  /// Stale agents stay stale. Of the others nothing is known between their last reports and the
  /// first ones that come now; they are stale where none comes for `max_age_s`.
  ///
  /// @param now_s The time in seconds, as it was.
  /// @param then_s The same instant in seconds, as it is from now on.
  /// @return The events, or an error, as advance().
  Result<std::vector<SwarmEvent>> begin_anew(double now_s, double then_s);

  /// @brief Says what became of the reports.
  /// @return The counts.
  [[nodiscard]] SwarmCounts counts() const;

  /// @brief Says where all agents are that have not been removed: stale ones, and those heard of
  /// once, too. Heights that are kept apart are left out.
  /// @param time_s The time in seconds.
  /// @return The agents in ascending order of ids; none at a time outside the motion domain.
  [[nodiscard]] std::vector<LiveMover> movers(double time_s) const;
  /// @brief The same into the caller's vector.
  /// @param time_s The time in seconds.
  /// @param[out] movers The agents; overwritten.
  void movers(double time_s, std::vector<LiveMover>& movers) const;

  /// @brief Says which agents that have not been removed were unknown for a time. Staleness is that
  /// of the last advance().
  /// @param time_s Until when, in seconds.
  /// @return The silences in ascending order of ids.
  [[nodiscard]] std::vector<Silence> silences(double time_s) const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace beespace
