// The columns of a table of fixes: those of points, and when it was and how fast each moved.
#pragma once

#include "io/table/column_schema.hpp"

namespace beespace::io {

const ColumnSchema& track_columns();

// "vx", "velocity_east", "vel_n_m_s".
NamePattern velocity_names();

}  // namespace beespace::io
