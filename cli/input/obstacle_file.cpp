#include "cli/input/obstacle_file.hpp"

#include "io/bytes/byte_source.hpp"
#include "io/load_obstacles.hpp"

#include <utility>
#include <variant>

namespace beespace::cli {
namespace {

std::string numbered(std::size_t number) {
  return "obstacles[" + std::to_string(number) + "]";
}

const char* kind_of(const Obstacle& obstacle) {
  if (std::holds_alternative<Sphere>(obstacle)) return "a sphere";
  if (std::holds_alternative<Box>(obstacle)) return "a box";
  if (std::holds_alternative<Ground>(obstacle)) return "the ground";
  return std::holds_alternative<UprightCylinder>(obstacle) ? "a cylinder" : "a prism";
}

}  // namespace

Result<ObstacleMap> load_obstacle_map(const std::string& file) {
  auto obstacles = io::load_obstacles(file);
  if (!obstacles) return std::move(obstacles).error();
  auto map = ObstacleMap::of(std::move(obstacles).value());
  if (map) return map;
  const Error& error = map.error();
  const std::string which = error.location.record ? numbered(*error.location.record) + ": " : "";
  return Error{ErrorCode::kMalformedRecord, which + error.message, {io::source_name(file)}};
}

std::string shown_obstacle(std::size_t number, const Obstacle& obstacle) {
  return numbered(number) + ", " + kind_of(obstacle);
}

}  // namespace beespace::cli
