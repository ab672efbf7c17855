#include "cli/show/shown_obstacles.hpp"

#include "cli/input/obstacle_file.hpp"

#include <utility>

namespace beespace::cli {

Result<std::vector<Obstacle>> load_shown_obstacles(const std::string& file) {
  if (file.empty()) return std::vector<Obstacle>();
  const auto map = load_obstacle_map(file);
  if (!map) return map.error();
  const auto all = map->obstacles();
  return std::vector<Obstacle>(all.begin(), all.end());
}

Status show_obstacles(const std::vector<Obstacle>& obstacles, analysis::Scene& scene) {
  if (obstacles.empty()) return std::monostate{};
  report::SwarmFacts& swarm = analysis::swarm_of(scene);
  if (swarm.origin) {
    return Error{ErrorCode::kUnknownFrame,
                 "obstacles are in metres, and '" + swarm.title +
                     "' is in degrees; give it in metres, or leave --obstacles out",
                 {}};
  }
  swarm.obstacles = obstacles;
  swarm.notes.emplace_back(
      "obstacles are drawn, and nothing is said of them: whether any comes too close, 'beespace "
      "verify --obstacles' says");
  return std::monostate{};
}

}  // namespace beespace::cli
