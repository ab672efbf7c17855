// Obstacles as globes and maps draw them: upright, between two heights.
#pragma once

#include "report/facts.hpp"

#include <beespace/geodesy.hpp>

#include <optional>
#include <string>
#include <vector>

namespace beespace::report {

// A cylinder, or a sphere within its heights.
struct RoundShape {
  GeographicPosition middle;
  double radius_m = 0.0;
  bool is_sphere = false;
};

struct MapObstacle {
  std::string name;   // as messages of the command call it: "obstacles[2], a box"
  const char* shape;  // as files of obstacles do: "box"
  std::string words;  // how high it is, and how wide a round one: plain text
  Heights heights;    // above what heights of bees are counted from; it may have no end
  // As it is drawn: counterclockwise at height `low_m`, up to `high_m`, both finite. What is round
  // lies within the outline, and what is thinner than 10 cm is drawn as wide.
  std::vector<GeographicPosition> outline;
  double low_m = 0.0;
  double high_m = 0.0;
  std::optional<RoundShape> round = {};
};

struct MapObstacles {
  std::vector<MapObstacle> obstacles;
  std::vector<std::string> notes{};  // what was left out
};

// All but the ground, which is everywhere. What has no end in height is drawn somewhat farther than
// bees fly.
MapObstacles map_obstacles(const SnapshotFacts& facts);
MapObstacles map_obstacles(const RecordingFacts& facts);

}  // namespace beespace::report
