// Where a bee was: its fixes, one after the other in time.
//
// Between two fixes it moves in the straight line through both at constant velocity, exactly: the
// rational line, whatever rounds when it is computed. Before the first and after the last fix it is
// not there. Units: metres, and seconds from any zero that all tracks of a recording share.
#pragma once

#include <beespace/point.hpp>

#include <vector>

namespace beespace {

struct Fix {
  double time_s = 0.0;
  Point position;

  friend constexpr bool operator==(const Fix&, const Fix&) = default;
};

struct Track {
  std::vector<Fix> fixes;  // of strictly ascending times

  // The bee is never farther than this from where the straight lines say: 0 for a path that is made
  // of them, more for one that they only approximate (see bezier_path.hpp).
  double tolerance_m = 0.0;
};

}  // namespace beespace
