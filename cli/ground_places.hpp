// What the distances of a vertical threshold between geographic positions are taken of: those
// brought to height 0, and heights apart from them.
#pragma once

#include "io/load_points.hpp"

#include <beespace/point.hpp>

#include <vector>

namespace beespace::cli {

// Both empty where the points themselves are asked about.
struct GroundPlaces {
  std::vector<Point> ground = {};
  std::vector<double> heights_m = {};
};

GroundPlaces ground_places(const io::LoadedPoints& loaded, bool vertical);

}  // namespace beespace::cli
