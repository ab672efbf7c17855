/// @file
/// @brief What each search needs to know: the threshold, and how much of the machine to use.
#pragma once

#include <beespace/not_given.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace beespace {

/// @brief What each search needs to know.
///
/// Ownership: `heights_m` and `other_heights_m` refer to the caller's memory, which must outlive
/// the options and must not change while a search reads it.
struct SearchOptions {
  /// @brief The threshold in metres. Two points conflict when their distance is below it. Finite
  /// and above zero, inside the coordinate domain (see Point). Must be given: there is no default.
  double threshold_m = kNotGiven;

  /// @brief Whether a distance of exactly the threshold is a conflict: "<=" instead of "<".
  bool inclusive = false;

  /// @brief How many threads may work, the calling one included; 0 means one per processor. The
  /// answer is the same for every number.
  unsigned threads = 1;

  /// @brief Pairs and neighbours can outnumber the points a thousandfold: a search that would
  /// return more of them than this returns ErrorCode::kTooManyResults instead.
  std::uint64_t max_results = std::numeric_limits<std::uint64_t>::max();

  /// @brief The vertical threshold in metres, or in the unit of `height_unit_m`.
  ///
  /// If it is given, two points conflict when they are closer than `threshold_m` horizontally (in x
  /// and y) and closer than this in height (z): a cylinder instead of a sphere. Each of the two is
  /// compared on its own, as real numbers. The nearest of a point is then the nearest by the
  /// straight line among those in its cylinder.
  std::optional<double> vertical_m = {};

  /// @brief Empty, or a height for each point, kept apart from the positions: for `vertical_m`
  /// between points whose third axis is not the height.
  ///
  /// Positions are then horizontal: of geographic ones, those brought to height 0 (see to_ecef).
  /// The straight line is that of the positions and the heights: the root of the sum of the squares
  /// of both distances.
  std::span<const double> heights_m = {};
  /// @brief The same of the other set, in searches between two sets. Either both sets have heights
  /// that are kept apart, or none has.
  std::span<const double> other_heights_m = {};

  /// @brief The length in metres of one unit of heights that are kept apart, where these are not
  /// metres: 0.3048 for feet; 1e-6 to 1e6. `vertical_m` is then in that unit too, and compared with
  /// the heights as they are, exactly. Straight lines are in metres in any case.
  double height_unit_m = 1.0;
};

}  // namespace beespace
