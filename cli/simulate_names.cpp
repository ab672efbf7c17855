#include "cli/simulate_names.hpp"

#include "cli/json_text.hpp"
#include "cli/terminal.hpp"

#include <variant>

namespace beespace::cli {
namespace {

const char* kind_of(const Obstacle& obstacle) {
  if (std::holds_alternative<Sphere>(obstacle)) return "a sphere";
  if (std::holds_alternative<Box>(obstacle)) return "a box";
  if (std::holds_alternative<Ground>(obstacle)) return "the ground";
  return std::holds_alternative<UprightCylinder>(obstacle) ? "a cylinder" : "a prism";
}

}  // namespace

std::string SimulateNames::bee(PointId bee) const {
  return ids.empty() ? std::to_string(bee) : printable(ids[bee]);
}

std::string SimulateNames::bee_as_json(PointId bee) const {
  return ids.empty() ? std::to_string(bee) : json_string(ids[bee]);
}

std::string SimulateNames::obstacle(std::size_t number, const Obstacle& obstacle) const {
  const bool of_file = number >= scenario_obstacles;
  std::string text =
      "obstacles[" + std::to_string(of_file ? number - scenario_obstacles : number) + "]";
  text += " of " + (of_file ? printable(obstacles_file) : std::string("the scenario"));
  return text + ", " + kind_of(obstacle);
}

}  // namespace beespace::cli
