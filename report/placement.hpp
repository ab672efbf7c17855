// Where on the Earth positions in metres lie.
#pragma once

#include <beespace/geodesy.hpp>
#include <beespace/point.hpp>

#include <string>

namespace beespace::report {

struct Placement {
  GeographicPosition origin = {};  // of x = y = z = 0
  double heading_deg = 0.0;        // where x points, clockwise from true north
  bool y_to_the_right = false;     // of x, seen from above; otherwise to its left
  std::string words = {};          // who says so, and what is to be said of it
  bool height_known = true;        // otherwise that of the origin is 0, and heights count from it
  bool above_sea = false;          // that of the origin counts from mean sea level
};

// From metres as given to metres east and north of the origin along the ground, and heights.
class PlacementAxes {
 public:
  explicit PlacementAxes(const Placement& placement);

  [[nodiscard]] Point operator()(const Point& p) const;
  [[nodiscard]] double height_of(double z) const { return z + up_m_; }
  // Whether what goes round to the left as given goes round to the right on the Earth.
  [[nodiscard]] bool mirrors() const { return side_ > 0.0; }

 private:
  double sine_ = 0.0;
  double cosine_ = 1.0;
  double side_ = -1.0;
  double up_m_ = 0.0;
};

}  // namespace beespace::report
