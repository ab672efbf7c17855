// From a file, or standard input, to bees and what they intend: where each is, and where it wants
// to go or how it would like to fly.
//
// Reads text tables, plain or gzip-compressed, whose header names the columns: x, y, z, and as far
// as they are there
// - id; otherwise bees are numbered in their order, from 0;
// - vx, vy, vz: how fast it flies now;
// - goal_x, goal_y, goal_z: where it wants to go;
// - want_vx, want_vy, want_vz: the velocity that it would like to have;
// - max_speed_mps, max_acceleration_mps2: what it can do.
// Metres and metres per second unless the header names another unit; z up. Of what has three
// columns all are there, or none.
#pragma once

#include "io/plans/flight_plans.hpp"

#include <beespace/result.hpp>

#include <string>
#include <string_view>

namespace beespace::io {

// `path` is a file name, or "-" for standard input. Errors carry file, line and column: of a table
// those of load_points(), kMissingColumn, kMalformedRecord also where two bees have the same id,
// kOutsideDomain also for limits that are not above zero.
Result<FlightPlans> load_flight_plans(const std::string& path, PlanNeed need);

// The same for bytes in memory (copied); `name` stands for the file.
Result<FlightPlans> load_flight_plans_from_memory(std::string_view content, const std::string& name,
                                                  PlanNeed need);

}  // namespace beespace::io
