#include "avoidance/constraints/hull_obstacle_separation.hpp"

#include <cmath>
#include <limits>

namespace beespace::avoidance {

namespace {

class HullObstacleSearch {
 public:
  HullObstacleSearch(const Hull& hull, const obstacles::ConvexPiece& piece)
      : hull_(hull), piece_(piece) {}

  ObstacleSeparation operator()(std::span<const Vector3> remembered, double enough_m) {
    approach(enough_m);
    for (const Vector3& normal : remembered) consider(normal);
    if (best_.gap >= enough_m) return best_;
    const Vector3 found = best_.normal;
    consider({found.x, found.y, 0.0});
    consider({0.0, 0.0, 1.0});
    consider({0.0, 0.0, -1.0});
    consider(separate(hull_.axis, piece_, enough_m).normal);
    return best_;
  }

 private:
  void consider(const Vector3& out) {
    const double far = length(out);
    if (!(far > 0.0)) return;
    const Vector3 normal = out * (1.0 / far);
    const double edge = piece_.support(normal);
    const double gap = hull_.lowest(normal) - edge;
    if (!std::isfinite(gap) || gap <= best_.gap) return;
    best_ = {normal, gap, edge};
  }

  // Towards the point of the hull that is closest to the piece, along the way to the corner that
  // is lowest seen from the piece (Frank and Wolfe: An algorithm for quadratic programming, 1956).
  void approach(double enough_m) {
    constexpr int kMost = 24;
    constexpr double kClose = 1e-12;
    constexpr double kNearly = 0.02;
    Vector3 place = closest_on_way(hull_.axis, piece_);
    for (int k = 0; k < kMost; ++k) {
      const obstacles::Facing facing = piece_.facing(place);
      const Vector3& normal = facing.normal;
      consider(normal);
      if (!(facing.surface.distance_m > 0.0)) return;
      const Vector3 corner = hull_.lowest_point(normal);
      const double missing = dot(normal, place - corner) / length(normal);
      const double close = best_.gap >= enough_m ? kNearly : kClose;
      if (!(missing > close * facing.surface.distance_m)) return;
      const Segment way{place, corner - place};
      const Vector3 next = closest_on_way(way, piece_);
      if (next == place) return;
      place = next;
    }
  }

  const Hull& hull_;
  const obstacles::ConvexPiece& piece_;
  ObstacleSeparation best_{{0.0, 0.0, 1.0}, -std::numeric_limits<double>::infinity(), 0.0};
};

}  // namespace

ObstacleSeparation separate(const Hull& hull, const obstacles::ConvexPiece& piece,
                            std::span<const Vector3> remembered, double enough_m) {
  return HullObstacleSearch(hull, piece)(remembered, enough_m);
}

ObstacleSeparation part_inside(const Hull& hull, const obstacles::Facing& out) {
  const double edge = dot(out.normal, core::vector_of(out.surface.point));
  return {out.normal, hull.lowest(out.normal) - edge, edge};
}

}  // namespace beespace::avoidance
