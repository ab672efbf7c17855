// What bees and obstacles of a flight are called.
#pragma once

#include "io/json/json_writer.hpp"

#include <beespace/obstacle.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace beespace::cli {

struct FlightNames {
  std::vector<std::string> ids = {};   // of the file; empty where bees are called by their numbers
  std::size_t scenario_obstacles = 0;  // so many, the first ones, are not of a file
  std::string obstacles_file = {};

  // For people.
  [[nodiscard]] std::string bee(PointId bee) const;
  // A number, or a string where the file says so.
  void write_bee(io::JsonWriter& json, PointId bee) const;
  // "obstacles[2], a box of city.json".
  [[nodiscard]] std::string obstacle(std::size_t number, const Obstacle& obstacle) const;
};

}  // namespace beespace::cli
