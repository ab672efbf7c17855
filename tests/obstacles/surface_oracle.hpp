// The distance of a point from an obstacle, computed independently of the library: the surface
// becomes faces, and the nearest face is found, in long doubles. Whether a point lies inside
// follows from the winding number of the outline.
#pragma once

#include <beespace/obstacle.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

namespace beespace::test {

using Real = long double;

inline Real real(double value) {
  return static_cast<Real>(value);
}

struct Flat {
  Real x;
  Real y;
};

inline Real distance_to_edge(const Corner& a, const Corner& b, const Flat& p) {
  const Real length = std::hypot(real(b.x) - real(a.x), real(b.y) - real(a.y));
  const Real ux = (real(b.x) - real(a.x)) / length;
  const Real uy = (real(b.y) - real(a.y)) / length;
  const Real along = (p.x - real(a.x)) * ux + (p.y - real(a.y)) * uy;
  const Real beside = (p.y - real(a.y)) * ux - (p.x - real(a.x)) * uy;
  const Real beyond = along < 0.0L ? -along : std::max(along - length, 0.0L);
  return std::hypot(beyond, beside);
}

inline bool winds_around(const std::vector<Corner>& outline, const Flat& p) {
  Real turned = 0.0L;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Corner& a = outline[i];
    const Corner& b = outline[(i + 1) % outline.size()];
    const Real ax = real(a.x) - p.x;
    const Real ay = real(a.y) - p.y;
    const Real bx = real(b.x) - p.x;
    const Real by = real(b.y) - p.y;
    turned += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return std::abs(turned) > 3.0L;
}

// Each answers: how far is the place from the surface, below zero inside.
class SurfaceOracle {
 public:
  SurfaceOracle(const Point& place) : at_{real(place.x), real(place.y)}, z_(real(place.z)) {}

  Real operator()(const Sphere& sphere) const {
    const Real x = at_.x - real(sphere.center.x);
    const Real y = at_.y - real(sphere.center.y);
    return std::hypot(x, y, z_ - real(sphere.center.z)) - real(sphere.radius_m);
  }

  Real operator()(const Ground& ground) const { return z_ - real(ground.height_m); }

  // A prism over a rectangle; of a flat one the faces lie on each other.
  Real operator()(const Box& box) const {
    const Real x = std::max(real(box.low.x) - at_.x, at_.x - real(box.high.x));
    const Real y = std::max(real(box.low.y) - at_.y, at_.y - real(box.high.y));
    const Real z = std::max(real(box.low.z) - z_, z_ - real(box.high.z));
    const auto face = [](Real to, Real beside, Real also) {
      return std::hypot(to, std::max(beside, 0.0L), std::max(also, 0.0L));
    };
    const auto either = [](double low, double high, Real value) {
      return std::min(std::abs(value - real(low)), std::abs(value - real(high)));
    };
    const Real faces = std::min({face(either(box.low.x, box.high.x, at_.x), y, z),
                                 face(either(box.low.y, box.high.y, at_.y), x, z),
                                 face(either(box.low.z, box.high.z, z_), x, y)});
    return x < 0.0L && y < 0.0L && z < 0.0L ? -faces : faces;
  }

  Real operator()(const UprightCylinder& cylinder) const {
    const Real far = std::hypot(at_.x - real(cylinder.x), at_.y - real(cylinder.y));
    const Real beside = far - real(cylinder.radius_m);
    return of_faces(std::abs(beside), beside < 0.0L, cylinder.heights);
  }

  Real operator()(const UprightPrism& prism) const {
    Real wall = std::numeric_limits<Real>::infinity();
    const auto& outline = prism.outline;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Corner& to = outline[(i + 1) % outline.size()];
      if (outline[i].x == to.x && outline[i].y == to.y) continue;
      wall = std::min(wall, distance_to_edge(outline[i], to, at_));
    }
    return of_faces(wall, winds_around(outline, at_), prism.heights);
  }

 private:
  // The nearest of walls and both lids; `wall` is how far the wall is in the plane.
  [[nodiscard]] Real of_faces(Real wall, bool within, const Heights& heights) const {
    const Real low = real(heights.low_m);
    const Real high = real(heights.high_m);
    const Real off = std::max({low - z_, z_ - high, 0.0L});
    Real nearest = std::hypot(wall, off);
    for (const Real lid : {low, high}) {
      if (!std::isfinite(lid)) continue;
      nearest = std::min(nearest, std::hypot(within ? 0.0L : wall, z_ - lid));
    }
    return within && low < z_ && z_ < high ? -nearest : nearest;
  }

  Flat at_;
  Real z_;
};

inline Real true_distance(const Obstacle& obstacle, const Point& place) {
  return std::visit(SurfaceOracle(place), obstacle);
}

}  // namespace beespace::test
