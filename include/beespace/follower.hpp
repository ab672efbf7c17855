/// @file
/// @brief The agent's side of the protocol: takes or refuses commands, and says where to be now.
///
/// Small, for a companion computer: no allocation, no threads, no clock of its own.
#pragma once

#include <beespace/advise.hpp>
#include <beespace/command.hpp>
#include <beespace/export.hpp>
#include <beespace/result.hpp>

#include <cstdint>

namespace beespace {

/// @brief Where an agent should be.
struct Setpoint {
  Mover nominal;         ///< Where it should be and how fast, in metres and metres per second.
  Velocity correction;   ///< What it flies in addition, in metres per second (BranchState).
  bool holding = false;  ///< Whether it stands, at the end of its branch.

  friend constexpr bool operator==(const Setpoint&, const Setpoint&) = default;
};

/// @brief Holds one branch, and changes it as the rules allow.
///
/// Thread safety: none. A plain value, freely copied.
class BEESPACE_API Follower {
 public:
  /// @brief An agent that is on no branch: it takes a root alone.
  /// @param agent Its number.
  /// @param planned What is planned with (Tube::planned): by its acceleration it brakes.
  /// @param period_s A tick in seconds; above zero.
  /// @return The follower, or ErrorCode::kInvalidArgument.
  static Result<Follower> make(AgentId agent, const FlightLimits& planned, double period_s);

  /// @brief Goes on after a restart with what was stored.
  ///
  /// A clock that was set anew may be behind the one before: by twice its error. So commands are
  /// taken again two ticks after the first advance(): this is enough where the clock is never off
  /// by more than a tick.
  ///
  /// @param stored What was stored.
  /// @return Success, or ErrorCode::kInvalidArgument for what cannot have been stored by a follower
  ///   of this agent.
  Status restore(const StoredBranch& stored);

  /// @brief Sets the tick; it never runs backwards. Before the first call no command is taken.
  /// @param tick The tick by the agent's clock.
  void advance(Tick tick);

  /// @brief Takes a command or refuses it.
  /// @param command The command, as it came: anything may be in it.
  /// @return What was done; kTaken: store what stored() says, then send this (and reports).
  Acknowledgement receive(const Command& command);

  /// @brief Answers a planner that was started anew: promises to refuse all older epochs.
  /// @param epoch The epoch of the planner.
  /// @return Whether it is not older than one that was promised before, or than that of its branch.
  ///   Then store what stored() says, and send it.
  bool promise(std::uint32_t epoch);

  /// @brief Forgets its branch: the agent is not where it should be, and must join anew, with an
  /// epoch that is greater than all that it knows. Store what stored() says.
  void lose();

  /// @brief Where it should be.
  /// @param after_s Seconds since its tick, zero or more.
  /// @return The setpoint; of an agent on no branch it says nothing: see held().
  [[nodiscard]] Setpoint setpoint(double after_s) const;

  /// @brief The branch that it is on.
  /// @return Its number; 0: none.
  [[nodiscard]] BranchNumber held() const { return stored_.branch.number; }
  /// @brief The tick.
  /// @return The latest that it was told.
  [[nodiscard]] Tick tick() const { return stored_.tick; }
  /// @brief What to store.
  /// @return A reference into this.
  [[nodiscard]] const StoredBranch& stored() const { return stored_; }

 private:
  Follower() = default;

  [[nodiscard]] CommandReply judge(const Command& command) const;
  [[nodiscard]] CommandReply judge_root(const Command& root) const;
  [[nodiscard]] BranchState at(Tick tick) const;

  StoredBranch stored_;
  BranchState now_;  // on its branch, at its tick
  AgentId agent_ = 0;
  FlightLimits planned_;
  double period_s_ = 0.0;
  Tick takes_from_ = 0;   // the tick
  bool ticks_ = false;    // whether its tick was set
  bool resumes_ = false;  // whether it was restored, and its tick not set since
};

}  // namespace beespace
