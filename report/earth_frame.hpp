// What lies over a wide part of the Earth, to look at: metres east and north along the ground, and
// heights above the WGS84 ellipsoid. A plane would fall away from the ground: by 78 m in 10 km.
#pragma once

#include <beespace/geodesy.hpp>
#include <beespace/point.hpp>

#include <optional>
#include <span>
#include <vector>

namespace beespace::report {

// A map around an origin. East and north of a place are those of the angle between its vertical and
// that of the origin, in the direction in which it leans, by the radii of curvature at the origin.
// Within a distance d of the origin lengths along the ground are right to a share of
// d²/(6 R²) + 0.0105 d/R, with R = 6,371 km: to 0.21 m a kilometre at 100 km, to 5.8 m at 1,000 km.
// At a height h bees are farther apart than shown by a share of h/R. The way back finds a place
// again to a micrometre and a bit of its height (to_geographic), but for the antipode's
// whereabouts.
class EarthFrame {
 public:
  // `origin` is one that to_ecef takes; its height does not count.
  explicit EarthFrame(const GeographicPosition& origin);

  // Of an ECEF position: x east, y north, z its height.
  [[nodiscard]] Point place_of(const Point& ecef) const;
  // The way back.
  [[nodiscard]] GeographicPosition position_of(const Point& place) const;

 private:
  Point east_;
  Point north_;
  Point up_;
  double east_radius_m_;
  double north_radius_m_;
};

// ECEF positions as EarthFrame has them: for looking at, not for distances.
struct LocalPlaces {
  GeographicPosition origin;
  std::vector<Point> places;
};
// The origin is below the middle of all, at height 0, unless it is given; where their middle is
// that of the Earth, below the first.
LocalPlaces around_middle(std::span<const Point> ecef,
                          const std::optional<GeographicPosition>& origin_wanted = {});

// A bee that flies straight from one position to another is shown on the straight line between
// their places: how far from it, at most (to a good approximation).
double bend_m(const EarthFrame& frame, const Point& from, const Point& to);

}  // namespace beespace::report
