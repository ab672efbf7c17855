// In which unit each coordinate of a table is, once its columns are known, and what heights are
// counted from.
#pragma once

#include "io/table/column_options.hpp"
#include "io/table/column_schema.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// What is said, behind its name, of a column whose unit is the pixel, where --scale is not given.
inline constexpr std::string_view kIsInPixels = " is in pixels";

// Fills in units, units_taken and datum. Errors: kInvalidArgument where a unit must be said (with
// column), or where what is asked for does not fit; kUnsupportedFormat for a unit that is not read.
std::optional<Error> settle_coordinate_units(const ColumnSchema& schema, const TableLayout& table,
                                             const ColumnOptions& options, ColumnChoice& choice);

// From the units of the table to metres.
Point in_metric(const Point& point, const ColumnChoice& choice);

}  // namespace beespace::io
