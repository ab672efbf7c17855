#include "cli/input/flight_names.hpp"

#include "cli/console/terminal.hpp"
#include "io/obstacle_name.hpp"

namespace beespace::cli {

std::string FlightNames::bee(PointId bee) const {
  return ids.empty() ? std::to_string(bee) : printable(ids[bee]);
}

void FlightNames::write_bee(io::JsonWriter& json, PointId bee) const {
  ids.empty() ? json.value(bee) : json.value(ids[bee]);
}

std::string FlightNames::obstacle(std::size_t number, const Obstacle& obstacle) const {
  if (number < scenario_obstacles) return io::obstacle_name(number, obstacle) + " of the scenario";
  return io::obstacle_name(number - scenario_obstacles, obstacle) + " of " +
         printable(obstacles_file);
}

}  // namespace beespace::cli
