// A swarm seen from above, and from the side: two panels, one below the other, that share the axis
// across.
#pragma once

#include "report/facts.hpp"
#include "report/figure/density.hpp"
#include "report/figure/panel.hpp"

#include <beespace/point.hpp>

#include <optional>
#include <vector>

namespace beespace::report {

// The least box around some points.
class Extent {
 public:
  void add(const Point& point);
  [[nodiscard]] bool empty() const { return !(low_.x <= high_.x); }
  [[nodiscard]] const Point& low() const { return low_; }
  [[nodiscard]] const Point& high() const { return high_; }

 private:
  Point low_ = {kNone, kNone, kNone};
  Point high_ = {-kNone, -kNone, -kNone};
  static constexpr double kNone = 1e300;
};

struct View {
  enum class From { kAbove, kSide };

  From from;
  Panel panel;

  [[nodiscard]] Spot spot_of(const Point& point) const {
    return {panel.across.scale(point.x),
            panel.upwards.scale(from == From::kAbove ? point.y : point.z)};
  }
};

// The sides of the squares in which a view counts bees, and those at risk.
inline constexpr double kDensityCell = 3.0;
inline constexpr double kRiskCell = 12.0;
// Empty squares all over the view's panel.
Density density_over(const View& view, double side);

// From above with the same scale on both axes; from the side with heights drawn larger or smaller
// where they would be a line or a tower, which its heading then says. Widths and heights of panels
// are multiples of kViewStep.
inline constexpr double kViewStep = 12.0;
std::vector<View> views_of(const Extent& extent, const SwarmFacts& swarm, Spot corner,
                           double width);

}  // namespace beespace::report
