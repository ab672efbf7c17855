// Where a bee was: its fixes, one after the other in time.
//
// Between two fixes it moves in the straight line through both at constant velocity, exactly: the
// rational line, whatever rounds when it is computed. Before the first and after the last fix it is
// not there. Units: metres, and seconds from any zero that all tracks of a recording share.
#pragma once

#include <beespace/export.hpp>
#include <beespace/point.hpp>

#include <limits>
#include <optional>
#include <vector>

namespace beespace {

struct Fix {
  double time_s = 0.0;
  Point position;

  friend constexpr bool operator==(const Fix&, const Fix&) = default;
};

struct Track {
  std::vector<Fix> fixes;  // of strictly ascending times

  // Empty, or a height for each fix, kept apart from the positions: for a vertical threshold
  // between bees whose third axis is not the height. Then positions are horizontal: of geographic
  // ones, those brought to height 0 (see to_ecef).
  std::vector<double> heights_m = {};

  // The bee is never farther than this from where the straight lines say: 0 for a path that is made
  // of them, more for one that they only approximate (see bezier_path.hpp).
  double tolerance_m = 0.0;
};

// Where the bee is at a time, rounded; nowhere before its first and after its last fix, and between
// two fixes that are more than `max_gap_s` apart.
BEESPACE_API std::optional<Point> position_at(
    const Track& track, double time_s, double max_gap_s = std::numeric_limits<double>::infinity());

}  // namespace beespace
