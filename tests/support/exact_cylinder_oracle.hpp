// The answers of searches with a vertical threshold, from the definition and in integers of any
// size: an oracle that shares no code with the library.
#pragma once

#include "tests/support/exact_oracle.hpp"

#include <beespace/points_view.hpp>
#include <beespace/search_options.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace beespace::test {

using WideInteger = boost::multiprecision::cpp_int;

// One set, or two.
struct CylinderScene {
  std::vector<Point> points;
  std::vector<Point> others;
  std::vector<double> heights;  // empty where the heights are z
  std::vector<double> other_heights;
  bool two_sets = false;
  double threshold_m = 1.0;
  double vertical_m = 1.0;
  double height_unit_m = 1.0;

  [[nodiscard]] bool apart() const { return !heights.empty() || !other_heights.empty(); }

  [[nodiscard]] PointsView view() const { return PointsView(points).with_heights(heights); }
  [[nodiscard]] PointsView other_view() const {
    return PointsView(others).with_heights(other_heights);
  }

  [[nodiscard]] SearchOptions options(bool inclusive, unsigned threads = 1) const {
    SearchOptions options;
    options.threshold_m = threshold_m;
    options.vertical_m = vertical_m;
    options.inclusive = inclusive;
    options.threads = threads;
    options.height_unit_m = height_unit_m;
    return options;
  }
};

class ExactCylinders {
 public:
  explicit ExactCylinders(const CylinderScene& scene) : scene_(scene) {
    unit_ = std::min({0, exponent_of(scene.threshold_m), exponent_of(scene.vertical_m)});
    for (const auto* points : {&scene.points, &scene.others}) {
      unit_ = std::min(unit_, lowest_exponent(*points));
    }
    for (const auto* heights : {&scene.heights, &scene.other_heights}) {
      for (const double height : *heights) unit_ = std::min(unit_, exponent_of(height));
    }
    ours_ = scaled_places(scene.points, scene.heights);
    theirs_ = scene.two_sets ? scaled_places(scene.others, scene.other_heights) : ours_;
  }

  [[nodiscard]] bool in_cylinder(std::size_t i, std::size_t j, bool inclusive) const {
    const WideInteger reach = whole(scene_.threshold_m);
    const WideInteger level = level_squared(i, j);
    const WideInteger up = abs(ours_[i].height - theirs_[j].height);
    const WideInteger most = whole(scene_.vertical_m);
    if (inclusive) return level <= reach * reach && up <= most;
    return level < reach * reach && up < most;
  }

  // Row i: the points in the cylinder of point i.
  [[nodiscard]] std::vector<std::vector<PointId>> rows(bool inclusive) const {
    std::vector<std::vector<PointId>> rows(ours_.size());
    for (std::size_t i = 0; i < ours_.size(); ++i) {
      for (std::size_t j = 0; j < theirs_.size(); ++j) {
        if (!scene_.two_sets && i == j) continue;
        if (in_cylinder(i, j, inclusive)) rows[i].push_back(static_cast<PointId>(j));
      }
    }
    return rows;
  }

  // Of those in its row the one that is nearest by the straight line, the lowest of several.
  [[nodiscard]] std::optional<PointId> nearest(std::size_t i,
                                               const std::vector<PointId>& row) const {
    std::optional<PointId> best;
    for (const PointId j : row) {
      if (!best || line_squared(i, j) < line_squared(i, *best)) best = j;
    }
    return best;
  }

 private:
  struct Place {
    std::array<WideInteger, 3> level;
    WideInteger height;
  };

  static int exponent_of(double value) { return value == 0.0 ? 0 : binary(value).exponent; }

  [[nodiscard]] WideInteger whole(double value) const {
    const Binary parts = binary(value);
    if (parts.mantissa == 0) return 0;
    return WideInteger(parts.mantissa) << (parts.exponent - unit_);
  }
  [[nodiscard]] std::vector<Place> scaled_places(const std::vector<Point>& points,
                                                 const std::vector<double>& heights) const {
    std::vector<Place> places;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& p = points[i];
      if (scene_.apart()) {
        places.push_back({{whole(p.x), whole(p.y), whole(p.z)}, whole(heights[i])});
      } else {
        places.push_back({{whole(p.x), whole(p.y), 0}, whole(p.z)});
      }
    }
    return places;
  }
  [[nodiscard]] WideInteger level_squared(std::size_t i, std::size_t j) const {
    WideInteger sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const WideInteger difference = ours_[i].level[axis] - theirs_[j].level[axis];
      sum += difference * difference;
    }
    return sum;
  }
  // In finer units, so that the unit of heights is whole too.
  [[nodiscard]] WideInteger line_squared(std::size_t i, std::size_t j) const {
    const Binary unit = binary(scene_.height_unit_m);
    const WideInteger up = (ours_[i].height - theirs_[j].height) * unit.mantissa;
    const int fine = std::min(0, unit.exponent);
    return (level_squared(i, j) << (-2 * fine)) + ((up * up) << (2 * (unit.exponent - fine)));
  }

  const CylinderScene& scene_;
  int unit_ = 0;
  std::vector<Place> ours_;
  std::vector<Place> theirs_;
};

}  // namespace beespace::test
