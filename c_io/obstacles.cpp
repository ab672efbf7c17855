// Obstacles that C reads from a file, as beespace_obstacles_create() takes them.
#include "c/door/door.hpp"
#include "c_io/door.hpp"
#include "c_io/read_options.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/load_obstacles.hpp"

#include <beespace_io.h>
#include <beespace/obstacle.hpp>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace beespace::c_io;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Box;
using beespace::Corner;
using beespace::Error;
using beespace::ErrorCode;
using beespace::Ground;
using beespace::Heights;
using beespace::Obstacle;
using beespace::ObstacleMap;
using beespace::Point;
using beespace::Result;
using beespace::Sphere;
using beespace::Status;
using beespace::UprightCylinder;
using beespace::UprightPrism;
using beespace::c::invalid;
namespace io = beespace::io;

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_io_obstacles {
  std::vector<Obstacle> obstacles;  // in which the outlines of the others lie
  std::vector<beespace_obstacle> list;
};

namespace {

void set_point(double (&into)[3], const Point& point) {
  into[0] = point.x;
  into[1] = point.y;
  into[2] = point.z;
}

void set_heights(beespace_obstacle& into, const Heights& heights) {
  if (std::isfinite(heights.low_m)) {
    into.flags |= BEESPACE_LOWEST;
    into.low[2] = heights.low_m;
  }
  if (std::isfinite(heights.high_m)) {
    into.flags |= BEESPACE_HIGHEST;
    into.high[2] = heights.high_m;
  }
}

void fill(beespace_obstacle& into, const Sphere& sphere) {
  into.kind = BEESPACE_SPHERE;
  set_point(into.center, sphere.center);
  into.radius_m = sphere.radius_m;
}

void fill(beespace_obstacle& into, const Box& box) {
  into.kind = BEESPACE_BOX;
  set_point(into.low, box.low);
  set_point(into.high, box.high);
}

void fill(beespace_obstacle& into, const Ground& ground) {
  into.kind = BEESPACE_GROUND;
  into.high[2] = ground.height_m;
}

void fill(beespace_obstacle& into, const UprightCylinder& cylinder) {
  into.kind = BEESPACE_CYLINDER;
  into.center[0] = cylinder.x;
  into.center[1] = cylinder.y;
  into.radius_m = cylinder.radius_m;
  set_heights(into, cylinder.heights);
}

void fill(beespace_obstacle& into, const UprightPrism& prism) {
  static_assert(sizeof(Corner) == 2 * sizeof(double));
  into.kind = BEESPACE_PRISM;
  if (!prism.outline.empty()) into.outline = &prism.outline.front().x;
  into.corners = static_cast<std::int64_t>(prism.outline.size());
  set_heights(into, prism.heights);
}

// What is no obstacle is told here, where the name of the file is known.
Status check(const std::vector<Obstacle>& obstacles, const std::string& path) {
  const auto map = ObstacleMap::of(obstacles);
  if (map) return std::monostate{};
  const Error& error = map.error();
  const std::string which =
      error.location.record ? "obstacles[" + std::to_string(*error.location.record) + "]: " : "";
  return Error{ErrorCode::kMalformedRecord, which + error.message, {io::source_name(path)}};
}

Result<std::unique_ptr<beespace_io_obstacles>> read_obstacles(const char* path) {
  const auto name = path_of(path);
  if (!name) return name.error();
  auto loaded = io::load_obstacles(*name);
  if (!loaded) return std::move(loaded).error();
  if (Status good = check(*loaded, *name); !good) return good.error();
  auto obstacles = std::make_unique<beespace_io_obstacles>();
  obstacles->obstacles = *std::move(loaded);
  for (const Obstacle& obstacle : obstacles->obstacles) {
    beespace_obstacle& into = obstacles->list.emplace_back();
    into.struct_size = sizeof into;
    std::visit([&into](const auto& solid) { fill(into, solid); }, obstacle);
  }
  return obstacles;
}

}  // namespace

extern "C" {

beespace_code beespace_io_read_obstacles(const char* path, beespace_io_obstacles** obstacles,
                                         beespace_io_error* error) {
  if (obstacles != nullptr) *obstacles = nullptr;
  return enter(error, [&]() -> Status {
    if (obstacles == nullptr) return invalid("the pointer to the obstacles is NULL", "obstacles");
    auto read = read_obstacles(path);
    if (!read) return std::move(read).error();
    *obstacles = (*read).release();
    return std::monostate{};
  });
}

void beespace_io_obstacles_free(beespace_io_obstacles* obstacles) {
  delete obstacles;
}

int64_t beespace_io_obstacles_count(const beespace_io_obstacles* obstacles) {
  return obstacles == nullptr ? 0 : static_cast<int64_t>(obstacles->list.size());
}

const beespace_obstacle* beespace_io_obstacles_list(const beespace_io_obstacles* obstacles) {
  return obstacles == nullptr || obstacles->list.empty() ? nullptr : obstacles->list.data();
}

}  // extern "C"
