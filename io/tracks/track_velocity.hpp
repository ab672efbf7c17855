// Which columns of a table of fixes hold the velocity, and whether they fit the position.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/table/unit_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

struct VelocityQuestion {
  const Header& header;
  const ColumnChoice& position;
  Frame frame;
  UnitChoice& units;
  bool needed = true;  // otherwise those whose unit would have to be said are left out
};

// Velocities are read where they are along the axes of the position: x, y, z in metres; east,
// north, up (or down) beside degrees, or beside metres that are named so; or beside either of these
// as speed and direction over ground, perhaps with a climb rate. Others are left out, and `notes`
// says why: they are no part of a track. `taken` says which units they have. Errors:
// kInvalidArgument where a unit must be said.
Result<std::optional<VelocityChoice>> choose_velocity(const VelocityQuestion& question,
                                                      std::vector<std::string>& notes,
                                                      std::vector<UnitTaken>& taken);

// From the units of the table to m/s along the axes; not-a-number stays what it is.
Velocity in_metric(const std::array<double, 3>& stated, const VelocityChoice& choice);

}  // namespace beespace::io
