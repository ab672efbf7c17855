/// @file
/// @brief Static obstacles: buildings, masts, no-fly zones, the ground.
///
/// How far is a point from an obstacle, and where is it nearest; when does a ball that flies
/// straight first touch it? Computed in doubles, to rounding: a distance is right to some 1e-14 of
/// the coordinates.
///
/// Units: metres and seconds, in one Cartesian frame in which z is up. Upright obstacles and the
/// ground have no meaning in geocentric coordinates.
#pragma once

#include <beespace/export.hpp>
#include <beespace/lifetimebound.hpp>
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

/// @brief A sphere.
struct Sphere {
  Point center;           ///< Its centre, in metres.
  double radius_m = 0.0;  ///< Its radius in metres; zero or more.
};

/// @brief A box along the axes.
struct Box {
  Point low;   ///< Its lowest corner, in metres.
  Point high;  ///< Its highest corner, in metres.
};

/// @brief All space below a height.
struct Ground {
  double height_m = 0.0;  ///< The height of the surface, in metres.
};

/// @brief An interval of heights.
struct Heights {
  double low_m = -std::numeric_limits<double>::infinity();  ///< Metres; -infinity for no end.
  double high_m = std::numeric_limits<double>::infinity();  ///< Metres; infinity for no end.
};

/// @brief A cylinder whose axis is vertical.
struct UprightCylinder {
  double x = 0.0;         ///< The axis, in metres.
  double y = 0.0;         ///< The axis, in metres.
  double radius_m = 0.0;  ///< The radius in metres; zero or more.
  Heights heights;        ///< From how low to how high.
};

/// @brief A corner of an outline on the ground.
struct Corner {
  double x = 0.0;  ///< Metres along the first axis.
  double y = 0.0;  ///< Metres along the second axis.
};

/// @brief A prism whose edges are vertical: what its outline encloses, between two heights.
struct UprightPrism {
  /// @brief Corner after corner, either way round, the last joined to the first. It need not be
  /// convex, but must not cross or touch itself. The last corner may repeat the first.
  std::vector<Corner> outline;
  /// @brief From how low to how high.
  Heights heights;
};

/// @brief Any obstacle.
using Obstacle = std::variant<Sphere, Box, Ground, UprightCylinder, UprightPrism>;

/// @brief Where an obstacle is nearest to a point.
struct NearestSurface {
  Point point;              ///< The nearest point of its surface, in metres.
  double distance_m = 0.0;  ///< The distance in metres; below zero inside, by the depth.
};

/// @brief Finds where the surface of an obstacle is nearest to a point.
///
/// Complexity: checking an outline of n corners costs n^2: for repeated queries, use an
/// ObstacleMap. Thread safety: no state is kept.
///
/// @param obstacle The obstacle.
/// @param point The point, in metres.
/// @return The nearest point of the surface; of several that are as near, any. Or an error:
///   - ErrorCode::kInvalidArgument: an obstacle that is not valid (a radius below zero, a box or
///     heights upside down, an outline of fewer than three corners, with one given twice, that
///     crosses or touches itself, or that encloses nothing);
///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a value that is not of the motion domain
///     (see mover.hpp).
BEESPACE_API Result<NearestSurface> nearest_surface(const Obstacle& obstacle, const Point& point);

/// @brief Says when a ball that flies straight, at constant velocity, first touches or overlaps an
/// obstacle.
///
/// The time is never too late. A ball that comes within some 1e-14 of the coordinates may count as
/// touching. Thread safety: no state is kept.
///
/// @param obstacle The obstacle.
/// @param ball The centre of the ball in metres, and its velocity in metres per second.
/// @param radius_m The radius of the ball in metres; zero or more. Of zero: when the point gets
///   there.
/// @param horizon_s How far to look ahead, in seconds.
/// @return The time in seconds within [0, horizon_s], or absent; or an error as nearest_surface.
BEESPACE_API Result<std::optional<double>> first_contact_s(const Obstacle& obstacle,
                                                           const Mover& ball, double radius_m,
                                                           double horizon_s);

/// @brief The nearest obstacle of a map.
struct NearestObstacle {
  std::size_t obstacle = 0;  ///< The index of the obstacle.
  NearestSurface surface;    ///< Where it is nearest.
};

/// @brief The first contact with an obstacle of a map.
struct ObstacleContact {
  std::size_t obstacle = 0;  ///< The index of the obstacle.
  double begins_s = 0.0;     ///< When the contact begins, in seconds.
};

/// @brief Many obstacles, checked and ordered in space, so that those near to a point are found
/// fast.
///
/// Ownership: holds a copy of all obstacles; copies of a map share it. Thread safety: any number of
/// threads may ask at the same time.
class BEESPACE_API ObstacleMap {
 public:
  /// @brief A map of no obstacles.
  ObstacleMap();
  /// @brief Frees the obstacles when no copy shares them.
  ~ObstacleMap();
  /// @brief Shares the obstacles. A move is a copy, so a moved-from map is still a map.
  ObstacleMap(const ObstacleMap&);
  /// @brief Shares the obstacles.
  /// @return This.
  ObstacleMap& operator=(const ObstacleMap&);

  /// @brief Makes a map of obstacles.
  /// @param obstacles The obstacles, in metres.
  /// @return The map; or an error as nearest_surface, with the obstacle in ErrorLocation::record.
  static Result<ObstacleMap> of(std::vector<Obstacle> obstacles);

  /// @brief Gives the obstacles, in the order in which they were given.
  /// @return A view of them, in the memory of the map.
  [[nodiscard]] std::span<const Obstacle> obstacles() const BEESPACE_LIFETIMEBOUND;

  /// @brief Finds the obstacle whose surface distance is least: inside one, the one in which the
  /// point is deepest.
  /// @param point The point, in metres.
  /// @param within_m The largest distance in metres that counts.
  /// @return The nearest obstacle, of equals the first; absent where none is within `within_m`, and
  ///   for a point beyond the motion domain.
  [[nodiscard]] std::optional<NearestObstacle> nearest(
      const Point& point, double within_m = std::numeric_limits<double>::infinity()) const;

  /// @brief Finds the first obstacle that a ball touches that flies straight, as first_contact_s.
  /// @param ball The centre of the ball in metres, and its velocity in metres per second.
  /// @param radius_m The radius of the ball in metres; zero or more.
  /// @param horizon_s How far to look ahead, in seconds.
  /// @return The first contact, of those at the same time with the first obstacle, or absent; or an
  ///   error as first_contact_s.
  [[nodiscard]] Result<std::optional<ObstacleContact>> first_contact(const Mover& ball,
                                                                     double radius_m,
                                                                     double horizon_s) const;

  /// @cond internal
  class State;
  // For the library's own use.
  [[nodiscard]] const State& state() const { return *state_; }
  /// @endcond

 private:
  std::shared_ptr<const State> state_;
};

}  // namespace beespace
