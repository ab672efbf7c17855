#include "cli/input/obstacle_file.hpp"

#include "io/bytes/byte_source.hpp"
#include "io/load_obstacles.hpp"
#include "io/obstacle_name.hpp"

#include <utility>

namespace beespace::cli {

Result<ObstacleMap> load_obstacle_map(const std::string& file) {
  auto obstacles = io::load_obstacles(file);
  if (!obstacles) return std::move(obstacles).error();
  auto map = ObstacleMap::of(std::move(obstacles).value());
  if (map) return map;
  const Error& error = map.error();
  const std::string which =
      error.location.record ? io::obstacle_number(*error.location.record) + ": " : "";
  return Error{ErrorCode::kMalformedRecord, which + error.message, {io::source_name(file)}};
}

}  // namespace beespace::cli
