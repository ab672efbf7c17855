#include "report/obstacles_json.hpp"

#include <array>
#include <cmath>
#include <variant>

namespace beespace::report {
namespace {

std::array<double, 3> numbers_of(const Point& point) {
  return {point.x, point.y, point.z};
}

void write_heights(io::JsonWriter& json, const Heights& heights) {
  if (std::isfinite(heights.low_m)) json.member("low_m", heights.low_m);
  if (std::isfinite(heights.high_m)) json.member("high_m", heights.high_m);
}

void write(io::JsonWriter& json, const Sphere& sphere) {
  json.member("kind", "sphere").member("center", numbers_of(sphere.center));
  json.member("radius_m", sphere.radius_m);
}

void write(io::JsonWriter& json, const Box& box) {
  json.member("kind", "box")
      .member("low", numbers_of(box.low))
      .member("high", numbers_of(box.high));
}

void write(io::JsonWriter& json, const beespace::Ground& ground) {
  json.member("kind", "ground").member("height_m", ground.height_m);
}

void write(io::JsonWriter& json, const UprightCylinder& cylinder) {
  json.member("kind", "cylinder").member("center", std::array<double, 2>{cylinder.x, cylinder.y});
  json.member("radius_m", cylinder.radius_m);
  write_heights(json, cylinder.heights);
}

void write(io::JsonWriter& json, const UprightPrism& prism) {
  json.member("kind", "prism").begin_array("outline");
  for (const Corner& corner : prism.outline) {
    json.begin_array().value(corner.x).value(corner.y).end();
  }
  json.end();
  write_heights(json, prism.heights);
}

}  // namespace

void write_obstacles(io::JsonWriter& json, const std::vector<Obstacle>& obstacles) {
  if (obstacles.empty()) return;
  json.begin_array("obstacles");
  for (const Obstacle& obstacle : obstacles) {
    json.begin_object();
    std::visit([&json](const auto& solid) { write(json, solid); }, obstacle);
    json.end();
  }
  json.end();
}

}  // namespace beespace::report
