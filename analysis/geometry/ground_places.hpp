// What the distances of a vertical threshold are taken of where heights are apart from positions:
// positions brought to height 0, geographic ones, or whose heights have the threshold's own unit.
#pragma once

#include "io/points/loaded_points.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <optional>
#include <vector>

namespace beespace::analysis {

// Both empty where the points themselves are asked about.
struct GroundPlaces {
  std::vector<Point> ground = {};
  std::vector<double> heights_m = {};  // in the unit of `vertical_m`
  std::optional<double> vertical_m = {};

  // What searches are asked about: these, or the points themselves. Refers to both.
  [[nodiscard]] PointsView view(const std::vector<Point>& points) const {
    return PointsView(ground.empty() ? points : ground).with_heights(heights_m);
  }
};

// `height_unit` is that of all that is compared. A threshold in the unit of the heights is compared
// with them as they stand.
GroundPlaces ground_places(const io::LoadedPoints& loaded,
                           const std::optional<io::StatedLength>& vertical, io::Unit height_unit);

}  // namespace beespace::analysis
