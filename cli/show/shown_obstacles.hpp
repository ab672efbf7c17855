// What stands in the way of a swarm, to be drawn beside it.
#pragma once

#include "analysis/scene/scene.hpp"

#include <beespace/obstacle.hpp>
#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

// `file` is a name, "-" for standard input, or empty: none. Errors: as load_obstacle_map.
Result<std::vector<Obstacle>> load_shown_obstacles(const std::string& file);

// Those of a file, in the metres of the scene. Error: kUnknownFrame where that is in degrees.
Status show_obstacles(const std::vector<Obstacle>& obstacles, analysis::Scene& scene);

}  // namespace beespace::cli
