/// @file
/// @brief Where an agent was: its fixes, one after the other in time.
///
/// Between two fixes it moves in the straight line through both at constant velocity, exactly: the
/// rational line, whatever rounds when it is computed. Before the first and after the last fix it
/// is absent. Units: metres, and seconds from any zero that all tracks of a recording share.
#pragma once

#include <beespace/export.hpp>
#include <beespace/point.hpp>

#include <limits>
#include <optional>
#include <vector>

namespace beespace {

/// @brief A known position at a known time.
struct Fix {
  double time_s = 0.0;  ///< The time in seconds.
  Point position;       ///< The position in metres.

  friend constexpr bool operator==(const Fix&, const Fix&) = default;
};

/// @brief The recorded positions of one agent.
struct Track {
  /// @brief The fixes, of strictly ascending times.
  std::vector<Fix> fixes;

  /// @brief Empty, or a height for each fix, kept apart from the positions: for a vertical
  /// threshold between agents whose third axis is not the height. Positions are then horizontal: of
  /// geographic ones, those brought to height 0 (see to_ecef). In metres, or in the options'
  /// `height_unit_m`.
  std::vector<double> heights_m = {};

  /// @brief The largest distance in metres of the agent from the straight lines: 0 for a path that
  /// is made of them, more for one that they only approximate (see bezier_path.hpp).
  double tolerance_m = 0.0;
};

/// @brief Says where an agent is at a time.
///
/// Complexity: logarithmic in the number of fixes. Thread safety: no state is kept.
///
/// @param track The recorded positions.
/// @param time_s The time in seconds.
/// @param max_gap_s The longest time in seconds between two fixes that is bridged by a straight
///   line.
/// @return The position in metres, rounded; absent before the first and after the last fix, and
///   between two fixes that are more than `max_gap_s` apart.
BEESPACE_API std::optional<Point> position_at(
    const Track& track, double time_s, double max_gap_s = std::numeric_limits<double>::infinity());

}  // namespace beespace
