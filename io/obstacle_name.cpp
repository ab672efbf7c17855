#include "io/obstacle_name.hpp"

#include <variant>

namespace beespace::io {
namespace {

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

std::string obstacle_number(std::size_t number) {
  return "obstacles[" + std::to_string(number) + "]";
}

std::string obstacle_name(std::size_t number, const Obstacle& obstacle) {
  const char* const name = std::visit([](const auto& solid) { return name_of(solid); }, obstacle);
  return obstacle_number(number) + ", " + name;
}

}  // namespace beespace::io
