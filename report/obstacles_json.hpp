// Obstacles as pages draw them.
#pragma once

#include "io/json/json_writer.hpp"

#include <beespace/obstacle.hpp>

#include <vector>

namespace beespace::report {

// The member `obstacles`, as files of obstacles have it (io/load_obstacles).
void write_obstacles(io::JsonWriter& json, const std::vector<Obstacle>& obstacles);

}  // namespace beespace::report
