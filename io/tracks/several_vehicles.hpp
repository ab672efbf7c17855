// Tables whose rows have columns for several vehicles beside each other: x, y, z, x2, y2, z2 or
// A_x, A_y, B_x, B_y or leader_lat, leader_lon, follower_lat, follower_lon.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

// What is wrong with a header that has more than one set of coordinates, which would not be taken:
// kMissingColumn. Nothing where the others are known to be no places of another vehicle, such as
// goals, velocities and what another filter makes of the same place.
std::optional<Error> several_vehicles(const TableLayout& table);

// The same of a place as north, east, down, as vehicles that count downwards have it.
std::optional<Error> downward(const TableLayout& table);

}  // namespace beespace::io
