/// @file
/// @brief Guides a fleet whose positions are not exact, and whose messages are late or lost.
///
/// A Guide plans on *nominal* states, which it knows exactly, as it made them. It keeps, for each
/// agent, all branches on which the agent can still be, claims the hull of all of them, and keeps
/// claims apart (advise.hpp). The true agent is in a tube around its nominal path (fleet.hpp).
/// So as long as the fleet keeps its contract, that is, its figures are true, *true* positions keep
/// the threshold, whatever is lost, delayed, doubled or reordered. An agent that breaks the
/// contract is named. The proof is in docs/prevention.md.
///
/// Units: metres and seconds, in one Cartesian frame in which z is up. Time is counted in ticks
/// (command.hpp).
#pragma once

#include <beespace/advise.hpp>
#include <beespace/agent_id.hpp>
#include <beespace/command.hpp>
#include <beespace/export.hpp>
#include <beespace/fleet.hpp>
#include <beespace/lifetimebound.hpp>
#include <beespace/not_given.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/separation.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace beespace {

/// @brief What a Guide needs to know.
///
/// Ownership: `obstacles` refers to the caller's map, which must outlive the Guide; `fences` is
/// copied.
struct GuideOptions {
  /// @brief The threshold in metres: no two agents shall come closer than this. Must be given.
  double threshold_m = kNotGiven;
  Separation separation = {};  ///< What must stay free around each agent.

  LinkFigures link = {};      ///< The tick, and how messages go.
  FleetFigures figures = {};  ///< Of each agent that has none of its own.
  FlightLimits limits = {.max_acceleration_mps2 = 5.0};  ///< The same. Finite accelerations only.

  const ObstacleMap* obstacles = nullptr;  ///< The static obstacles; null for none.
  std::span<const Fence> fences = {};      ///< The half-spaces that no agent leaves.
  double clearance_m = kNotGiven;          ///< From obstacles and fences; see AdviseOptions.
  double intruder_horizon_s = 10.0;        ///< How far to look ahead for intruders, in seconds.
  bool planar = false;                     ///< Whether agents keep their heights.

  /// @brief The epoch: greater than that of every planner that guided this fleet before; above
  /// zero.
  std::uint32_t epoch = 1;
  unsigned threads = 1;  ///< How many threads may work; 0 means one per processor.
};

/// @brief An agent that wants to join. It stands, and will hold its place.
struct JoinRequest {
  AgentId agent = 0;                         ///< The caller's number.
  Point position = {};                       ///< Where it stands, in metres.
  double radius_m = 0.0;                     ///< Its own radius in metres; zero or more.
  std::optional<FleetFigures> figures = {};  ///< Its own figures, where they differ.
  std::optional<FlightLimits> limits = {};   ///< Its own limits, where they differ.
  /// @brief What its follower has promised (StoredBranch::promised): its branches are of that epoch
  /// where it is greater than that of the planner. So an agent that lost its branch joins anew with
  /// an epoch in which it has never been on one.
  std::uint32_t promised = 0;
};

/// @brief Whether an agent may join.
///
/// One that may not is not planned for, and certificates do not count it: let it move, or give it
/// as an intruder.
struct JoinAnswer {
  bool joined = false;                      ///< Whether its place is reserved: it is in the fleet.
  std::vector<AgentId> touches = {};        ///< Whose claims it would touch, ascending.
  std::vector<std::size_t> obstacles = {};  ///< Which obstacles it is too close to, ascending.
  std::vector<std::size_t> fences = {};     ///< Which fences it is too close to, ascending.
};

/// @brief Whether an agent keeps the contract of its figures.
enum class Contract : std::uint8_t {
  kKept,     ///< As far as reports tell.
  kDoubted,  ///< It may have left its tube. Not a false alarm if Tube::radius_m has room for it.
  kOut,      ///< It surely has left its tube, or deviates faster than it can.
};

/// @brief Why a contract is doubted or broken.
enum class ContractReason : std::uint8_t {
  kNone,       ///< It is kept.
  kDeviation,  ///< It is too far from where it should be.
  kRate,       ///< Its deviation changes faster than the figures allow.
  kSilent,     ///< It was not heard of for longer than the figures say.
  kNoBranch,   ///< It has lost its branch, or says that it is on one that it cannot be on.
  kFuture,     ///< Its report comes from the future.
};

/// @brief What a Guide says about one agent in one tick.
struct AgentGuidance {
  AgentId agent = 0;                              ///< Who.
  Contract contract = Contract::kKept;            ///< Whether its figures hold.
  ContractReason reason = ContractReason::kNone;  ///< Why not.
  /// @brief The all-clear: `keeps_apart`, `clear_of_intruders`, and a contract that is kept.
  bool certified = false;
  /// @brief Proven: as long as all keep the contract, it keeps the threshold from all others that
  /// keep it, and the clearance, for ever. Whether they do says `contract`: never of one that is
  /// out, and of one that is doubted its reports alone do not prove it.
  bool keeps_apart = false;
  /// @brief Predicted, not proven, for GuideOptions::intruder_horizon_s: no intruder comes too
  /// close, if all fly straight on, and the agent on its newest branch and as it is told now.
  bool clear_of_intruders = false;
  AdviceKind kind = AdviceKind::kNone;  ///< How it flies, compared with what is preferred.
  bool commanded = false;               ///< Whether there is a command for it in this tick.
  std::uint32_t branches = 0;           ///< On how many branches it can be.
  Mover nominal;                        ///< Its nominal state now, on the newest branch.
  double tube_m = 0.0;                  ///< The radius of its tube in metres.
  double deviation_m = 0.0;             ///< Of its last report, in metres; 0 before the first.
};

/// @brief Two agents without a certificate.
struct UncertifiedPair {
  AgentId first = 0;     ///< One agent; below `second`.
  AgentId second = 0;    ///< The other.
  double gap_m = 0.0;    ///< Between their claims, in metres.
  double clear_s = 0.0;  ///< As TooClose::clear_s.

  friend constexpr bool operator==(const UncertifiedPair&, const UncertifiedPair&) = default;
};

/// @brief An agent and an object by its index: an obstacle, a fence, an intruder.
struct AgentAndObject {
  AgentId agent = 0;       ///< The agent.
  std::size_t object = 0;  ///< The index of the object.
  double gap_m = 0.0;      ///< The distance in metres; of an intruder: how close they come.

  friend constexpr bool operator==(const AgentAndObject&, const AgentAndObject&) = default;
};

/// @brief What a Guide says in one tick.
struct Guidance {
  Tick tick = 0;                                   ///< The tick.
  std::vector<Command> commands;                   ///< To be sent, in ascending order of agents.
  std::vector<AgentGuidance> agents;               ///< In ascending order of agents.
  std::vector<UncertifiedPair> pairs;              ///< In ascending order of pairs.
  std::vector<AgentAndObject> near_obstacle;       ///< In ascending order.
  std::vector<AgentAndObject> near_fence;          ///< In ascending order.
  std::vector<AgentAndObject> intruder_conflicts;  ///< In ascending order.

  /// @brief Empties all; keeps the memory.
  void clear();
};

/// @brief An intruder: it flies among the agents and does as it likes. Best effort.
struct Intruder {
  Mover mover;                    ///< Where it is taken to be now, and how fast.
  double radius_m = 0.0;          ///< Its own radius in metres; zero or more.
  double position_error_m = 0.0;  ///< How far it may be from there, in metres.
  double speed_error_mps = 0.0;   ///< How far its velocity may be off, in m/s.

  friend constexpr bool operator==(const Intruder&, const Intruder&) = default;
};

/// @brief Guides a fleet, tick after tick.
///
/// An agent that is reported wrongly does not stop the others. An error of a call changes nothing,
/// but for three: while intruders are refused no agent is clear of them, a report of a branch that
/// was never sent marks its agent, and a step that was stopped has had its tick.
///
/// Thread safety: none; use one Guide per thread. A moved-from Guide can only be destroyed or
/// assigned to.
class BEESPACE_API Guide {
 public:
  /// @brief Makes a Guide of no agents.
  /// @param options What it needs to know.
  /// @return The Guide; or ErrorCode::kInvalidThreshold, ErrorCode::kInvalidArgument: as
  ///   Adviser::advise and tube_of; an epoch of zero; an infinite acceleration.
  static Result<Guide> make(const GuideOptions& options);
  Guide(const Guide&) = delete;
  Guide& operator=(const Guide&) = delete;
  /// @brief Takes over the fleet.
  Guide(Guide&&) noexcept;
  /// @brief Takes over the fleet.
  /// @return This.
  Guide& operator=(Guide&&) noexcept;
  /// @brief Frees its memory.
  ~Guide();

  /// @brief Says whether an agent may join; and if so, it has joined: its place is reserved.
  ///
  /// The next step() has a root command for it, again and again until it is acknowledged.
  ///
  /// @param request The agent.
  /// @return The answer; or ErrorCode::kInvalidArgument: an agent that has joined already, or has
  ///   left so lately that it may still take what was sent to it (unless
  ///   JoinRequest::promised is a newer epoch), figures or limits as tube_of;
  ///   ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: its position; ErrorCode::kTooManyPoints:
  ///   more agents than ids.
  Result<JoinAnswer> join(const JoinRequest& request);
  /// @brief The same without joining.
  /// @param request The agent.
  /// @return As join().
  Result<JoinAnswer> may_join(const JoinRequest& request);

  /// @brief Takes over an agent that another planner has guided: it has promised this epoch.
  ///
  /// It may not be clear of others: then the pairs are named.
  ///
  /// @param request The agent; its position counts for nothing.
  /// @param stored What its follower says after Follower::promise.
  /// @return Success; or an error as join(), or for a branch that cannot be.
  Status adopt(const JoinRequest& request, const StoredBranch& stored);

  /// @brief Says that agents exist of which nothing is known yet: until all are adopted, or
  /// removed, no agent is certified.
  /// @param agents Their numbers.
  void expect(std::span<const AgentId> agents);

  /// @brief Removes an agent: it has landed, or was found. Its place is free.
  /// @param agent Its number.
  /// @return Success; or ErrorCode::kInvalidArgument: it is not known.
  Status leave(AgentId agent);

  /// @brief Says where an agent shall go.
  /// @param agent Its number.
  /// @param goal The place, in metres; it stops there.
  /// @return Success; or ErrorCode::kInvalidArgument: it is not known; ErrorCode::kNotFinite,
  ///   ErrorCode::kOutsideDomain.
  Status set_goal(AgentId agent, const Point& goal);
  /// @brief Says which velocity an agent prefers, instead of a goal.
  /// @param agent Its number.
  /// @param velocity The velocity, in metres per second.
  /// @return As set_goal().
  Status set_preferred(AgentId agent, const Velocity& velocity);

  /// @brief Takes a report: in any order, any number of times.
  ///
  /// One of a tick that lies ahead waits until the next step, as a planner may have been held up.
  /// If it lies ahead of that too, the agent is named (ContractReason::kFuture). One of a tick
  /// before the agent joined is late, and names no agent.
  ///
  /// @param report The report.
  /// @return Success; or ErrorCode::kInvalidArgument: an agent that is not known, a branch that was
  ///   never sent, a tick beyond 10^18; ErrorCode::kNotFinite, ErrorCode::kOutsideDomain. An agent
  ///   that is on a branch that was never sent is named in the next step.
  Status take(const AgentReport& report);
  /// @brief Takes an acknowledgement: in any order, any number of times.
  /// @param acknowledgement The acknowledgement.
  /// @return Success; or ErrorCode::kInvalidArgument: of an agent that is not known, or of a
  ///   command that was never sent.
  Status take(const Acknowledgement& acknowledgement);

  /// @brief Says which intruders there are from now on.
  /// @param intruders The intruders; copied. Flown straight on until the next call.
  /// @return Success; or ErrorCode::kNotFinite, ErrorCode::kOutsideDomain,
  ///   ErrorCode::kInvalidArgument: one that cannot be used, by its index in ErrorLocation::record.
  ///   It may be anywhere: until the next call no agent is clear of intruders, and the others are
  ///   given way to.
  Status set_intruders(std::span<const Intruder> intruders);

  /// @brief Guides the fleet for one tick: to be called at its begin, after the messages that came
  /// until then.
  /// @param now The tick; after that of the call before. Ticks may be left out where loops are
  ///   closed on board; agents whose loop is closed on the ground are then named
  ///   (ContractReason::kSilent), as corrections were missing.
  /// @param[out] guidance What to send, and what is known; overwritten, and empty after an error.
  /// @param stop When a stop is requested, the call ends soon. The tick has passed all the same.
  /// @return Success; or ErrorCode::kTimeOrder: a tick that is not after the one before;
  ///   ErrorCode::kInvalidArgument: a tick beyond 10^18;
  ///   ErrorCode::kStopped.
  Status step(Tick now, Guidance& guidance, const std::stop_token& stop = {});

  /// @brief How many agents there are.
  /// @return The number.
  [[nodiscard]] std::size_t size() const;
  /// @brief The tube of an agent.
  /// @param agent Its number.
  /// @return The tube; or ErrorCode::kInvalidArgument: it is not known.
  [[nodiscard]] Result<Tube> tube(AgentId agent) const;
  /// @brief The claim of an agent: the places whose convex hull it is.
  /// @param agent Its number.
  /// @return The places in metres; or ErrorCode::kInvalidArgument: it is not known.
  [[nodiscard]] Result<std::vector<Point>> claim(AgentId agent) const;

 private:
  class State;
  explicit Guide(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace beespace
