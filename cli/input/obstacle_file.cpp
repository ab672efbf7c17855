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

const char* name_of(const Sphere&) {
  return "a sphere";
}
const char* name_of(const Box&) {
  return "a box";
}
const char* name_of(const Ground&) {
  return "the ground";
}
const char* name_of(const UprightCylinder&) {
  return "a cylinder";
}
const char* name_of(const UprightPrism&) {
  return "a prism";
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
  const char* const name = std::visit([](const auto& solid) { return name_of(solid); }, obstacle);
  return numbered(number) + ", " + name;
}

}  // namespace beespace::cli
