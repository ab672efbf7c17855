/// @file
/// @brief What a planner and an agent tell each other: commands, acknowledgements, reports.
///
/// Time is counted in *ticks*, integers, one per period of the planner; tick 0 is when the fleet
/// says. A *branch* is a nominal path: states at successive ticks, between which an agent changes
/// its velocity evenly, and after the last of which it brakes to a stop and stays (the *fallback*).
/// A command is a branch, and says from which other branches it departs, and when. The rules, and
/// why they hold however messages are lost, delayed, doubled and reordered, are in
/// docs/prevention.md.
///
/// Plain values of a fixed size: nothing here allocates memory. Units: metres and seconds.
#pragma once

#include <beespace/agent_id.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace beespace {

/// @brief The number of a tick: of the instant, or of the period that it begins.
using Tick = std::int64_t;

/// @brief The number of a branch: the epoch of its planner in the upper 32 bits, and a count below.
/// Newer ones are greater; 0 is none.
using BranchNumber = std::uint64_t;

/// @brief The epoch of a branch: each planner that is started has a greater one than all before it.
/// @param number The number of the branch.
/// @return Its epoch.
[[nodiscard]] constexpr std::uint32_t epoch_of(BranchNumber number) {
  return static_cast<std::uint32_t>(number >> 32U);
}

/// @brief The number of a branch.
/// @param epoch The epoch of the planner.
/// @param count Which of its branches, from 1.
/// @return The number.
[[nodiscard]] constexpr BranchNumber branch_number(std::uint32_t epoch, std::uint32_t count) {
  return (BranchNumber{epoch} << 32U) | count;
}

/// @brief A branch that another one departs from.
struct Ancestor {
  BranchNumber number = 0;  ///< The branch.
  /// @brief Up to this tick both lead the same way. An agent changes over before it, or not at all.
  Tick departs = 0;

  friend constexpr bool operator==(const Ancestor&, const Ancestor&) = default;
};

/// @brief One state of a branch, at a tick.
struct BranchState {
  Mover nominal;  ///< Where an agent is and how fast, in metres and metres per second.
  /// @brief Of a fleet whose loop is closed on the ground: what an agent flies in addition to the
  /// nominal velocity, in metres per second, changing evenly between ticks. Zero otherwise.
  Velocity correction;

  friend constexpr bool operator==(const BranchState&, const BranchState&) = default;
};

/// @brief A command: the branch that one agent shall be on.
struct Command {
  /// @brief The most states and ancestors of a command.
  static constexpr std::size_t kMostStates = 36;
  static constexpr std::size_t kMostAncestors = 16;  ///< @copydoc kMostStates

  AgentId agent = 0;              ///< For whom.
  BranchNumber number = 0;        ///< The branch.
  Tick starts = 0;                ///< The tick of the first state.
  std::uint32_t state_count = 0;  ///< How many of `states` count; one or more.
  /// @brief How many of `ancestors` count. Zero: a root. An agent that is on no branch takes it, as
  /// long as its states last.
  std::uint32_t ancestor_count = 0;
  std::array<BranchState, kMostStates> states;     ///< At `starts` and each tick after it.
  std::array<Ancestor, kMostAncestors> ancestors;  ///< In descending order of their numbers.

  /// @brief The states that count.
  /// @return A view of `states`.
  [[nodiscard]] std::span<const BranchState> path() const { return {states.data(), state_count}; }
  /// @brief The ancestors that count.
  /// @return A view of `ancestors`.
  [[nodiscard]] std::span<const Ancestor> departs_from() const {
    return {ancestors.data(), ancestor_count};
  }
};

/// @brief What an agent did with a command.
enum class CommandReply : std::uint8_t {
  kTaken,       ///< It is on that branch now.
  kOlder,       ///< It is on that branch or on a newer one; or promised to refuse its epoch.
  kTooLate,     ///< The branch that it is on has departed from it; of a root: its states are over.
  kTooEarly,    ///< The branch begins after the agent's tick, or that is not known. Not final.
  kNoAncestor,  ///< The branch that it is on is not an ancestor. Not final.
  kNoBranch,    ///< It has lost its branch, and must join anew.
  kInvalid,     ///< Of another agent, or no command: counts, numbers or states that cannot be.
};

/// @brief The reply to one command.
struct Acknowledgement {
  AgentId agent = 0;                            ///< Who replies.
  BranchNumber number = 0;                      ///< Of the command.
  CommandReply reply = CommandReply::kInvalid;  ///< What the agent did with it.
  BranchNumber held = 0;                        ///< The branch that it is on after that; or 0.
  Tick tick = 0;                                ///< Its tick at that moment.

  friend constexpr bool operator==(const Acknowledgement&, const Acknowledgement&) = default;
};

/// @brief What an agent says about itself.
struct AgentReport {
  AgentId agent = 0;                      ///< Who reports.
  BranchNumber held = 0;                  ///< The branch that it is on; 0: it lost it.
  Tick tick = 0;                          ///< Its tick as it was measured.
  double after_s = 0.0;                   ///< How long after that tick, in seconds; zero or more.
  Point position = {};                    ///< Where it was measured to be, in metres.
  std::optional<Velocity> velocity = {};  ///< How fast, in metres per second, where known.

  friend constexpr bool operator==(const AgentReport&, const AgentReport&) = default;
};

/// @brief What a Follower must remember to go on after a restart: where it has changed, store it
/// durably before anything is sent.
struct StoredBranch {
  Command branch;              ///< The branch that the agent is on; number 0: none.
  std::uint32_t promised = 0;  ///< It refuses epochs below this.
  Tick tick = 0;               ///< Its tick.
};

}  // namespace beespace
