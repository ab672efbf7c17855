// "Too close" in a cylinder: horizontally and in height, decided exactly.
#pragma once

#include "core/exact_distance.hpp"

#include <beespace/points_view.hpp>
#include <beespace/search_options.hpp>

#include <span>

namespace beespace::core {

// For options with a vertical threshold. Keeps a reference to the points, and to the heights.
class CylinderTest {
 public:
  CylinderTest(const PointsView& points, const SearchOptions& options)
      : points_(points),
        heights_m_(options.heights_m),
        level_(options.threshold_m, options.inclusive),
        upright_(*options.vertical_m, options.inclusive) {}

  [[nodiscard]] bool operator()(PointId i, PointId j) const {
    Point p = points_[i];
    Point q = points_[j];
    double height_p = p.z;
    double height_q = q.z;
    if (heights_m_.empty()) {
      p.z = q.z = 0.0;
    } else {
      height_p = heights_m_[i];
      height_q = heights_m_[j];
    }
    return upright_({height_p, 0.0, 0.0}, {height_q, 0.0, 0.0}) && level_(p, q);
  }

 private:
  const PointsView& points_;
  std::span<const double> heights_m_;
  ProximityTest level_;
  ProximityTest upright_;
};

}  // namespace beespace::core
