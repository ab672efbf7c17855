// What stands in the way and does not move: buildings, masts, no-fly zones, the ground.
//
// How far is a point from it, and where is it nearest; when does a ball that flies straight first
// touch it? Computed in doubles, to rounding: a distance is right to some 1e-14 of the coordinates.
//
// Units: metres, seconds, in one Cartesian frame in which z is up. Upright obstacles and the ground
// make no sense in geocentric coordinates.
#pragma once

#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace beespace {

struct Sphere {
  Point center;
  double radius_m = 0.0;
};

// Along the axes, from its lowest corner to its highest.
struct Box {
  Point low;
  Point high;
};

// Everything below a height.
struct Ground {
  double height_m = 0.0;
};

// From how low to how high; infinite for no end.
struct Heights {
  double low_m = -std::numeric_limits<double>::infinity();
  double high_m = std::numeric_limits<double>::infinity();
};

struct UprightCylinder {
  double x = 0.0;
  double y = 0.0;
  double radius_m = 0.0;
  Heights heights;
};

struct Corner {
  double x = 0.0;
  double y = 0.0;
};

// What its outline encloses: corner after corner, either way round, the last joined to the first.
// It need not be convex, but must not cross or touch itself. The last corner may repeat the first.
struct UprightPrism {
  std::vector<Corner> outline;
  Heights heights;
};

using Obstacle = std::variant<Sphere, Box, Ground, UprightCylinder, UprightPrism>;

// Where an obstacle is nearest to a point.
struct NearestSurface {
  Point point;              // of its surface
  double distance_m = 0.0;  // below zero: the point is inside, and so deep
};

// Errors, of all that follows: kInvalidArgument for an obstacle that is none (a radius below zero,
// a box or heights upside down, an outline of fewer than three corners, with one given twice, that
// crosses or touches itself, or that encloses nothing); kNotFinite and kOutsideDomain, which is the
// motion domain (see mover.hpp). Checking an outline of n corners costs n^2: to ask about one again
// and again, ask a map of it. Of two points of the surface that are as near, any.
BEESPACE_API Result<NearestSurface> nearest_surface(const Obstacle& obstacle, const Point& point);

// When a ball that flies straight, at constant velocity, first touches or overlaps the obstacle,
// within [0, horizon_s]; never too late. One that comes within some 1e-14 of the coordinates may
// count as touching. `radius_m` is zero or more: of zero, when the point gets there.
BEESPACE_API Result<std::optional<double>> first_contact_s(const Obstacle& obstacle,
                                                           const Mover& ball, double radius_m,
                                                           double horizon_s);

struct NearestObstacle {
  std::size_t obstacle = 0;  // which
  NearestSurface surface;
};

struct ObstacleContact {
  std::size_t obstacle = 0;
  double begins_s = 0.0;
};

// Many obstacles, checked and put in order, so that those near to a place are found fast.
//
// Ownership: holds a copy of all; copies of a map share it. Thread-safe.
class BEESPACE_API ObstacleMap {
 public:
  ObstacleMap();  // no obstacles
  ~ObstacleMap();
  // A move is a copy, so that one that was moved from is a map still.
  ObstacleMap(const ObstacleMap&);
  ObstacleMap& operator=(const ObstacleMap&);

  // Errors: as above, with the obstacle in place.record.
  static Result<ObstacleMap> of(std::vector<Obstacle> obstacles);

  [[nodiscard]] std::span<const Obstacle> obstacles() const;

  // The obstacle whose surface distance is least (inside one: the one it is deepest in), if that is
  // at most `within_m`; of equals the first. Nothing for a point beyond the motion domain.
  [[nodiscard]] std::optional<NearestObstacle> nearest(
      const Point& point, double within_m = std::numeric_limits<double>::infinity()) const;

  // The first that a ball touches that flies straight, as first_contact_s; of those at the same
  // time the first.
  [[nodiscard]] Result<std::optional<ObstacleContact>> first_contact(const Mover& ball,
                                                                     double radius_m,
                                                                     double horizon_s) const;

  class State;
  // For the library's own use.
  [[nodiscard]] const State& state() const { return *state_; }

 private:
  std::shared_ptr<const State> state_;
};

}  // namespace beespace
