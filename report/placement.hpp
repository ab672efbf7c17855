// Where on the Earth positions in metres lie.
#pragma once

#include <beespace/geodesy.hpp>

#include <string>

namespace beespace::report {

struct Placement {
  GeographicPosition origin = {};  // of x = y = z = 0
  double heading_deg = 0.0;        // where x points, clockwise from true north
  bool y_to_the_right = false;     // of x, seen from above; otherwise to its left
  std::string words = {};          // who says so, and what is to be said of it
};

}  // namespace beespace::report
