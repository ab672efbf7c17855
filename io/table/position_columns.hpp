// The columns of a table of points: where each is, and which it is.
#pragma once

#include "io/table/column_schema.hpp"

#include <string_view>

namespace beespace::io {

const ColumnSchema& position_columns();

// Whether it is a height above where each one took off, or above the ground below it:
// "relative_alt_m", "altitudeRelative", "alt_agl". Those of several are not comparable.
bool counts_from_takeoff(std::string_view name);

// Whether it is a height in hundreds of feet by pressure: "Flight Level", "FL". The latter may be
// the fork length of a fish, too.
bool names_flight_level(std::string_view name);

}  // namespace beespace::io
