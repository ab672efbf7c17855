// The columns of a table of points: where each is, and which it is.
#pragma once

#include "io/table/column_schema.hpp"

namespace beespace::io {

const ColumnSchema& position_columns();

}  // namespace beespace::io
