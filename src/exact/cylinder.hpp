// "Too close" in a cylinder: horizontally and in height, separately, decided exactly.
#pragma once

#include "exact/exact_distance.hpp"

#include <beespace/points_view.hpp>
#include <beespace/search_options.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace beespace::core {

// A place for searches with a vertical threshold. The height comes first; the horizontal distance
// is that of the three others. Where the height is z, the last of them is 0.
struct Upright {
  static constexpr std::size_t kAxes = 4;

  std::array<double, kAxes> at;

  [[nodiscard]] double height() const { return at[0]; }
  [[nodiscard]] Point level() const { return {at[1], at[2], at[3]}; }
};

// Points whose heights are z, or apart from them.
struct UprightPoints {
  PointsView points;
  std::span<const double> heights = {};  // empty, or one for each
  bool apart = false;                    // whether heights count, even of no points

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] Upright operator[](std::size_t i) const {
    const Point p = points[i];
    if (apart) return {{heights[i], p.x, p.y, p.z}};
    return {{p.z, p.x, p.y, 0.0}};
  }
};

// The points of a search with a vertical threshold; `apart` where any set has heights of its own.
inline UprightPoints upright(const PointsView& points, bool apart) {
  return {points, points.heights_m(), apart};
}

class CylinderTest {
 public:
  // For options with a vertical threshold.
  explicit CylinderTest(const PairOptions& options)
      : level_(options.threshold_m, options.inclusive),
        upright_(*options.vertical_m, options.inclusive) {}

  [[nodiscard]] bool operator()(const Upright& p, const Upright& q) const {
    return upright_({p.height(), 0.0, 0.0}, {q.height(), 0.0, 0.0}) && level_(p.level(), q.level());
  }

 private:
  ProximityTest level_;
  ProximityTest upright_;
};

// The straight line between two places, from their horizontal positions and heights. One unit of
// separate heights is `height_unit_m` metres.
class StraightLine {
 public:
  explicit StraightLine(double height_unit_m) : unit_(height_unit_m) {}

  // Rounded like doubles; relative error at most 9 u + O(u^2): the square of the height has a
  // rounding in the difference and one in the unit, both counted twice, and its own; three sums.
  [[nodiscard]] double squared(const Upright& p, const Upright& q) const {
    const double up = (p.height() - q.height()) * unit_;
    return squared_distance(p.level(), q.level()) + up * up;
  }

  // The sign of |p - q| - |r - s|, exactly, filter included.
  [[nodiscard]] int compare(const Upright& p, const Upright& q, const Upright& r,
                            const Upright& s) const;

  // As distance() rounds; of heights that are z exactly that.
  [[nodiscard]] double length(const Upright& p, const Upright& q) const;

 private:
  double unit_;
};

}  // namespace beespace::core
