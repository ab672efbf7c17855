/// @file
/// @brief What each search needs to know: the threshold, and how much of the machine to use.
///
/// Each search takes the options that it obeys, and no others. Heights that are kept apart from
/// positions belong to the points: see PointsView::with_heights.
#pragma once

#include <beespace/not_given.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>
#include <utility>

namespace beespace {

/// @brief How much of the machine a call uses, and how it can be ended early.
///
/// A number of threads converts to one: `find_nearest(points, 4)`.
struct RunOptions {
  /// @brief So many threads, which nothing stops.
  /// @param thread_count How many threads may work.
  /// @param stop_when Ends the call early.
  RunOptions(unsigned thread_count = 1,  // NOLINT(google-explicit-constructor)
             std::stop_token stop_when = {})
      : threads(thread_count), stop(std::move(stop_when)) {}

  /// @brief How many threads may work, the calling one included; 0 means one per processor. The
  /// answer is the same for every number.
  unsigned threads;
  /// @brief When a stop is requested, the call ends soon, with ErrorCode::kStopped and no answer.
  std::stop_token stop;
};

/// @brief What a search that returns pairs or neighbours needs to know: a threshold, and how many
/// of them there may be. Plain values; nothing is referred to.
struct PairOptions {
  /// @brief As SearchOptions::threshold_m. Must be given: there is no default.
  double threshold_m = kNotGiven;
  /// @brief As SearchOptions::inclusive.
  bool inclusive = false;
  /// @brief As SearchOptions::threads.
  unsigned threads = 1;

  /// @brief Pairs and neighbours can outnumber the points a thousandfold: a search that would
  /// return more of them than this returns ErrorCode::kTooManyResults instead.
  std::uint64_t max_results = std::numeric_limits<std::uint64_t>::max();

  /// @brief As SearchOptions::vertical_m.
  std::optional<double> vertical_m = {};
  /// @brief As SearchOptions::height_unit_m.
  double height_unit_m = 1.0;
  /// @brief As SearchOptions::stop.
  std::stop_token stop = {};

  /// @brief The same without a limit, for a search that returns no pairs.
  /// @return All but `max_results`.
  [[nodiscard]] struct SearchOptions without_limit() const;
};

/// @brief What a search with a threshold needs to know. Plain values; nothing is referred to.
struct SearchOptions {
  /// @brief The threshold in metres. Two points conflict when their distance is below it. Finite
  /// and above zero, inside the coordinate domain (see Point). Must be given: there is no default.
  double threshold_m = kNotGiven;

  /// @brief Whether a distance of exactly the threshold is a conflict: "<=" instead of "<".
  bool inclusive = false;

  /// @brief How many threads may work, the calling one included; 0 means one per processor. The
  /// answer is the same for every number.
  unsigned threads = 1;

  /// @brief The vertical threshold in metres, or in the unit of `height_unit_m`.
  ///
  /// If it is given, two points conflict when they are closer than `threshold_m` horizontally (in x
  /// and y) and closer than this in height: a cylinder instead of a sphere. Each of the two is
  /// compared on its own, as real numbers. The height is z, or the one that the points have apart
  /// from their positions (PointsView::with_heights). The nearest of a point is then the nearest by
  /// the straight line among those in its cylinder.
  std::optional<double> vertical_m = {};

  /// @brief The length in metres of one unit of heights that are kept apart, where these are not
  /// metres: 0.3048 for feet; 1e-6 to 1e6. `vertical_m` is then in that unit too, and compared with
  /// the heights as they are, exactly. Straight lines are in metres in any case.
  double height_unit_m = 1.0;

  /// @brief When a stop is requested, the search ends soon, with ErrorCode::kStopped and no answer.
  std::stop_token stop = {};

  /// @brief The same for a search that returns pairs or neighbours, as many as there are.
  operator PairOptions() const {  // NOLINT(google-explicit-constructor): nothing is lost
    return {threshold_m, inclusive,     threads, std::numeric_limits<std::uint64_t>::max(),
            vertical_m,  height_unit_m, stop};
  }
};

inline SearchOptions PairOptions::without_limit() const {
  return {threshold_m, inclusive, threads, vertical_m, height_unit_m, stop};
}

}  // namespace beespace
