/// @file
/// @brief Which recorded agents came closer than the threshold, and when? For whole tracks, each
/// with its own, unaligned and irregular times.
///
/// Between two fixes an agent moves in a straight line at constant velocity, exactly (see
/// track.hpp), so a pass between two fixes is found as well. Whether two are in conflict at some
/// instant is decided as real numbers on the given doubles.
#pragma once

#include <beespace/conflict.hpp>
#include <beespace/export.hpp>
#include <beespace/not_given.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>
#include <beespace/track.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace beespace {

/// @brief What a search in a recording needs to know. Plain values; nothing is referred to.
struct ConflictOptions {
  /// @brief The threshold in metres. Two agents are in conflict when their distance is below it;
  /// with `vertical_m`, their horizontal distance. Must be given: there is no default.
  double threshold_m = kNotGiven;

  /// @brief The vertical threshold in metres, or in the unit of `height_unit_m`. If it is given,
  /// two agents are in conflict when they are closer than `threshold_m` horizontally (in x and y)
  /// and closer than this in height (z), both at the same time.
  std::optional<double> vertical_m = {};

  /// @brief Whether a distance of exactly the threshold is a conflict: "<=" instead of "<".
  bool inclusive = false;

  /// @brief The longest time in seconds between two fixes of an agent that is bridged by a straight
  /// line. Where fixes are farther apart in time, the position in between is unknown: the agent
  /// counts as absent there, and RecordedConflicts::gaps says so. Above zero.
  double max_gap_s = std::numeric_limits<double>::infinity();

  /// @brief How many threads may work, the calling one included; 0 means one per processor. The
  /// answer is the same for every number.
  unsigned threads = 1;

  /// @brief More conflicts than this are an error, ErrorCode::kTooManyResults.
  std::uint64_t max_results = std::numeric_limits<std::uint64_t>::max();

  /// @brief The length in metres of one unit of heights that are kept apart from positions, where
  /// these are not metres: 0.3048 for feet. `vertical_m` and climb rates are then in that unit too,
  /// and compared with the heights as they are, exactly. Reported distances are in metres in any
  /// case.
  double height_unit_m = 1.0;

  /// @brief When a stop is requested, the search ends soon, with ErrorCode::kStopped and no answer.
  std::stop_token stop = {};
};

/// @brief Two consecutive fixes between which an agent counts as absent.
struct Gap {
  PointId track = 0;      ///< The index of the track.
  double begins_s = 0.0;  ///< The time of the fix before the gap, in seconds.
  double ends_s = 0.0;    ///< The time of the fix after the gap, in seconds.

  friend constexpr bool operator==(const Gap&, const Gap&) = default;
};

/// @brief The conflicts of a recording, and where it does not say.
struct RecordedConflicts {
  /// @brief In ascending order of (first, second, begins_s). A pair may be in conflict several
  /// times: the intervals do not overlap; two may share the instant at which the pair is exactly
  /// the threshold apart. Where tracks have a tolerance, an interval is as long as the two may have
  /// been closer than the threshold.
  std::vector<Conflict> conflicts;
  /// @brief The gaps, in ascending order of (track, begins_s).
  std::vector<Gap> gaps;
};

/// @brief Finds all conflicts between two of the tracks, over the whole time.
///
/// Thread safety: no state is kept.
///
/// @param tracks The recorded tracks, in metres and seconds; read in place. A track without fixes
/// is
///   an agent that never appears.
/// @param options The threshold and the gaps.
/// @return The conflicts and the gaps; or an error:
///   - ErrorCode::kInvalidThreshold: a threshold that is not given, or is no number above zero of
///     the motion domain (see mover.hpp);
///   - ErrorCode::kInvalidArgument: a `max_gap_s` that is not above zero, or a negative or infinite
///     tolerance;
///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain, ErrorCode::kTimeOrder: a value that is not
///     of the motion domain, or a time that does not come after the one before it, with the track
///     in ErrorLocation::record and the fix in the message;
///   - ErrorCode::kTooManyPoints: more tracks than ids;
///   - ErrorCode::kTooManyResults: more conflicts than ConflictOptions::max_results;
///   - ErrorCode::kStopped: a stop was requested.
BEESPACE_API Result<RecordedConflicts> find_conflicts(std::span<const Track> tracks,
                                                      const ConflictOptions& options);

/// @brief Finds the two tracks whose straight-line distance is least of all, over all the time in
/// which both are there.
///
/// Complexity: a few searches as find_conflicts, with thresholds that grow until a pair is found.
/// Thread safety: no state is kept.
///
/// @param tracks The recorded tracks, in metres and seconds; read in place.
/// @param max_gap_s As ConflictOptions::max_gap_s, in seconds.
/// @param run How many threads may work, and what ends the call early.
/// @return The two, when they are closest, and how close (all three times are the closest instant);
///   absent where no two are there at the same time; or an error as find_conflicts.
BEESPACE_API Result<std::optional<Conflict>> find_closest_encounter(
    std::span<const Track> tracks, double max_gap_s = std::numeric_limits<double>::infinity(),
    const RunOptions& run = {});

}  // namespace beespace
