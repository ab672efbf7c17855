// The columns of a table of flight plans: where a bee is, what it intends and what it can do.
#pragma once

#include "io/table/column_schema.hpp"

namespace beespace::io {

// Names are read as in "x", "start_x", "goal_x [m]", "target_y", "vx", "want_vx",
// "preferred_velocity_z", "max_speed_mps".
const ColumnSchema& plan_columns();

}  // namespace beespace::io
