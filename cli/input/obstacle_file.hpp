// Obstacles from a file, checked.
#pragma once

#include <beespace/obstacle.hpp>
#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

// `file` is a name, or "-" for standard input. Errors: as io::load_obstacles; kMalformedRecord for
// what is no obstacle, which is named.
Result<ObstacleMap> load_obstacle_map(const std::string& file);

}  // namespace beespace::cli
