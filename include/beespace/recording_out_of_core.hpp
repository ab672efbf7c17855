/// @file
/// @brief Which recorded agents came closer than the threshold, and when? For recordings that are
/// larger than memory.
///
/// Time is cut into windows that fit into the memory. A window has the straight pieces between two
/// fixes that reach into it, whole, so that what two neighbouring windows both see of two agents is
/// the same motion, of which the same is found; a conflict that goes on over a border is one again.
/// So each answer is that of beespace::find_conflicts, bit for bit.
///
/// Fixes wait in a temporary file that has no name, so that nothing is left of it when the program
/// ends, however it ends. What is read back is compared with a checksum.
#pragma once

#include <beespace/agent_id.hpp>
#include <beespace/export.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/out_of_core.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>
#include <beespace/track.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace beespace {

/// @brief Two agents that are closer than the threshold for some time: as Conflict, with the
/// caller's ids.
struct LargeConflict {
  AgentId first = 0;       ///< One agent; below `second`.
  AgentId second = 0;      ///< The other agent.
  double begins_s = 0.0;   ///< When they come closer than the threshold.
  double closest_s = 0.0;  ///< When they are closest in all that time.
  double ends_s = 0.0;     ///< When they are apart again.
  double closest_m = 0.0;  ///< Their straight-line distance at `closest_s`, in metres.

  friend constexpr bool operator==(const LargeConflict&, const LargeConflict&) = default;
};

/// @brief Two consecutive fixes between which it is unknown where an agent is.
struct LargeGap {
  AgentId agent = 0;      ///< The agent.
  double begins_s = 0.0;  ///< The time of the fix before the gap, in seconds.
  double ends_s = 0.0;    ///< The time of the fix after the gap, in seconds.

  friend constexpr bool operator==(const LargeGap&, const LargeGap&) = default;
};

/// @brief What there is of an agent.
struct LargeAgent {
  AgentId id = 0;           ///< The agent.
  std::uint64_t fixes = 0;  ///< How many fixes it has; one or more.
  double begins_s = 0.0;    ///< The time of the first one, in seconds.
  double ends_s = 0.0;      ///< The time of the last one, in seconds.
  double interval_s = 0.0;  ///< The median of the times between two fixes, the lower one of two in
                            ///< the middle; 0 of a single fix.

  friend constexpr bool operator==(const LargeAgent&, const LargeAgent&) = default;
};

/// @brief A fix as it was added.
struct LargeFix {
  AgentId agent = 0;      ///< The agent.
  Fix fix;                ///< When it was where.
  double height_m = 0.0;  ///< Its height, where heights are apart from positions; else 0.

  friend constexpr bool operator==(const LargeFix&, const LargeFix&) = default;
};

/// @brief Sees conflicts in ascending order of (first, second, begins_s), some a call. Must not
/// throw.
using LargeConflictVisitor = std::function<void(std::span<const LargeConflict>)>;
/// @brief Sees gaps in ascending order of (agent, begins_s), some a call. Must not throw.
using LargeGapVisitor = std::function<void(std::span<const LargeGap>)>;
/// @brief Sees agents in ascending order of their ids. Must not throw.
using LargeAgentVisitor = std::function<void(const LargeAgent&)>;
/// @brief Sees fixes in ascending order of (agent, time), some a call. Must not throw.
using LargeFixVisitor = std::function<void(std::span<const LargeFix>)>;

/// @brief Two fixes of one agent at one time, which is an error.
struct LargeTimeClash {
  AgentId agent = 0;             ///< The agent.
  double time_s = 0.0;           ///< The time in seconds.
  std::uint64_t first_row = 0;   ///< Which of all fixes that were added is the first of them.
  std::uint64_t second_row = 0;  ///< And which the second.

  friend constexpr bool operator==(const LargeTimeClash&, const LargeTimeClash&) = default;
};

/// @brief What the last search of a recording went through.
struct RecordingOutOfCoreFacts {
  std::uint64_t windows = 0;            ///< Windows with fixes.
  std::uint64_t copies = 0;             ///< How many more fixes were written than there are.
  std::uint64_t largest_window = 0;     ///< The fixes of the fullest window.
  std::uint64_t repeated = 0;           ///< Fixes that were said again, which do not count (see
                                        ///< RecordingOutOfCore::allow_repeated).
  bool encounters = false;              ///< Whether two agents are known at the same time.
  std::optional<LargeTimeClash> clash;  ///< What ErrorCode::kTimeOrder was about.
};

/// @brief A recording beyond memory, and the search for its conflicts.
///
/// Ownership: owns its memory and its temporary files. Thread safety: none. A moved-from
/// RecordingOutOfCore can only be destroyed or assigned to.
class BEESPACE_API RecordingOutOfCore {
 public:
  /// @brief No fixes.
  /// @param options The memory, the folder, the threads. The folder must have room for some 60
  ///   bytes a fix, while a search goes on for twice as much. Progress is told in fixes. If the
  ///   options make no sense, each call returns the error.
  explicit RecordingOutOfCore(const OutOfCoreOptions& options);
  RecordingOutOfCore(const RecordingOutOfCore&) = delete;
  RecordingOutOfCore& operator=(const RecordingOutOfCore&) = delete;
  /// @brief Takes over the fixes.
  RecordingOutOfCore(RecordingOutOfCore&&) noexcept;
  /// @brief Takes over the fixes.
  /// @return This.
  RecordingOutOfCore& operator=(RecordingOutOfCore&&) noexcept;
  /// @brief Gives the disk back.
  ~RecordingOutOfCore();

  /// @brief Adds fixes, of many agents and in any order; they are copied.
  /// @param agents The agent of each.
  /// @param times_s When it was there, in seconds from any zero that all fixes share.
  /// @param positions Where it was, in metres. All fixes have heights apart from their positions
  ///   (PointsView::with_heights, in ConflictOptions::height_unit_m), or none has.
  /// @return Success, or an error:
  ///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a value that is not of the motion domain
  ///     (see mover.hpp), with "times", "positions" or "heights" in ErrorLocation::array and its
  ///     place there in ErrorLocation::record; none was added;
  ///   - ErrorCode::kInvalidArgument: the options; arrays that do not fit together; heights where
  ///     fixes before have none, or none where these have; none was added;
  ///   - ErrorCode::kWriteFailed: the disk is full, or the folder cannot be written; after that
  ///     each call returns this error.
  Status add(std::span<const AgentId> agents, std::span<const double> times_s,
             const PointsView& positions);
  /// @brief How many fixes were added.
  /// @return The number.
  [[nodiscard]] std::uint64_t size() const;

  /// @brief Says with how many threads the calls that follow work, and what ends them: instead of
  /// what the options said.
  /// @param run The threads and the stop.
  void set_run(const RunOptions& run);

  /// @brief Says whether a fix may be said again: of the same agent, at the same time and place.
  /// Then it counts once. Otherwise it is an error, as two places at one time are in any case.
  /// @param allowed Whether it may.
  void allow_repeated(bool allowed);

  /// @brief Goes through all agents.
  /// @param visit Sees each.
  /// @return As find_conflicts(), but for the options.
  Status visit_agents(const LargeAgentVisitor& visit);

  /// @brief Goes through all fixes, each once. What is too small for exact comparison is zero.
  /// @param visit Sees them.
  /// @return As find_conflicts(), but for the options.
  Status visit_fixes(const LargeFixVisitor& visit);

  /// @brief Finds all conflicts between two of the agents, over the whole time, as
  /// beespace::find_conflicts.
  ///
  /// The memory holds the fixes of a window, and what its search needs of agents. Pairs that are
  /// close to each other at the same time come to that, as they do in memory.
  ///
  /// @param options The threshold and the gaps; `threads` and `stop` are those of this.
  /// @param conflicts Sees the conflicts, after the gaps.
  /// @param gaps Sees the gaps; or empty.
  /// @return Success, or an error, in which case visitors may have seen some:
  ///   - those of beespace::find_conflicts, but for those of single fixes, which add() tells;
  ///   - ErrorCode::kTimeOrder: an agent has two fixes at one time; which of all that were added is
  ///     the second of them is in ErrorLocation::record, and the first in the message;
  ///   - ErrorCode::kInvalidArgument: less memory than the threads need, or than the agents that
  ///     are there at one time need; the message says how much it takes;
  ///   - ErrorCode::kWriteFailed, ErrorCode::kReadFailed: of the temporary file;
  ///   - ErrorCode::kCorrupt: it does not hold what was written.
  Status find_conflicts(const ConflictOptions& options, const LargeConflictVisitor& conflicts,
                        const LargeGapVisitor& gaps = {});

  /// @brief Says what the last search went through.
  /// @return The facts.
  [[nodiscard]] RecordingOutOfCoreFacts facts() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace beespace
