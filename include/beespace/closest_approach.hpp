/// @file
/// @brief Two agents that move straight on: when are they closest, how close, and when in conflict?
///
/// Each moves in a straight line at constant velocity. They are in *conflict* in [0, horizon] when
/// their distance is below the threshold at some instant of it, decided as real numbers on the
/// given doubles: grazing at exactly the threshold is no conflict, unless
/// PredictOptions::inclusive. The air traffic literature calls the closest instant the closest
/// point of approach (CPA).
#pragma once

#include <beespace/conflict.hpp>
#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/not_given.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>

namespace beespace {

/// @brief What closest_approach needs to know. Plain values; nothing is referred to.
struct ApproachOptions {
  /// @brief As PredictOptions::threshold_m. Must be given: there is no default.
  double threshold_m = kNotGiven;
  /// @brief As PredictOptions::vertical_m, in metres.
  std::optional<double> vertical_m = {};
  /// @brief As PredictOptions::horizon_s.
  double horizon_s = 60.0;
  /// @brief As PredictOptions::inclusive.
  bool inclusive = false;
};

/// @brief What a prediction needs to know. Plain values; nothing is referred to.
struct PredictOptions {
  /// @brief The threshold in metres. Two agents are in conflict when their distance is below it;
  /// with `vertical_m`, their horizontal distance. Must be given: there is no default.
  double threshold_m = kNotGiven;

  /// @brief The vertical threshold in metres, or in the unit of `height_unit_m`. If it is given,
  /// two agents are in conflict when they are closer than `threshold_m` horizontally (in x and y)
  /// and closer than this in height (z), both at the same time.
  std::optional<double> vertical_m = {};

  /// @brief How far to look ahead, in seconds from now; zero or more.
  double horizon_s = 60.0;

  /// @brief Whether a distance of exactly the threshold is a conflict: "<=" instead of "<".
  bool inclusive = false;

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

  /// @brief When a stop is requested, the call ends soon, with ErrorCode::kStopped and no answer.
  std::stop_token stop = {};

  /// @brief What of it closest_approach needs to know, of agents whose height is z.
  /// @return The thresholds and the horizon.
  [[nodiscard]] ApproachOptions approach() const {
    return {threshold_m, vertical_m, horizon_s, inclusive};
  }
};

/// @brief How two agents approach each other within [0, horizon].
struct Approach {
  /// @brief When the straight-line distance of the two is least, in seconds from now; of several
  /// such instants the first.
  double closest_s = 0.0;
  /// @brief Their straight-line distance at that time, in metres.
  double closest_m = 0.0;

  /// @brief While they are in conflict, within [0, horizon]; absent when they never are. A conflict
  /// that begins at 0 is there now; one that ends at the horizon is still there then. With a single
  /// instant of contact (PredictOptions::inclusive) both ends are the same, up to rounding.
  std::optional<TimeSpan> conflict = {};
};

/// @brief Says when two agents are closest, how close, and while they are in conflict.
///
/// Complexity: constant. Thread safety: no state is kept.
///
/// @param first One agent: its position in metres, its velocity in metres per second.
/// @param second The other agent.
/// @param options The threshold and the horizon.
/// @return The approach; or an error:
///   - ErrorCode::kInvalidThreshold: a threshold that is not given, or is no number above zero of
///     the motion domain (see mover.hpp);
///   - ErrorCode::kInvalidArgument: a horizon or `vertical_m` that makes no sense;
///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a position or velocity that is not of the
///     motion domain, with 0 for `first` and 1 for `second` in ErrorLocation::record.
BEESPACE_API Result<Approach> closest_approach(const Mover& first, const Mover& second,
                                               const ApproachOptions& options);

}  // namespace beespace
