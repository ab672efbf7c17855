// Poses of robots in a plane: x, y and the direction in which each looks.
#pragma once

#include "io/table/table_layout.hpp"

namespace beespace::io {

// Whether a header names a robot, and "theta" or "yaw" beside x and y, which are in metres then,
// and not longitude and latitude.
bool names_planar_poses(const TableLayout& table);

}  // namespace beespace::io
