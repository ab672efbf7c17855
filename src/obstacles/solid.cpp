#include "obstacles/solid.hpp"

#include "obstacles/crossing.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::obstacles {

namespace {

// In the very centre all directions are alike; so near to it their squares would underflow.
constexpr double kInTheCenter = 0x1p-400;

struct NearestEnd {
  double at;
  double distance;  // below zero between the ends
  double normal;    // up or down
};

NearestEnd nearest_end(const Heights& heights, double z) {
  const double below = heights.low_m - z;
  const double above = z - heights.high_m;
  return below > above ? NearestEnd{heights.low_m, below, -1.0}
                       : NearestEnd{heights.high_m, above, 1.0};
}

Facing facing(const Vector3& point, double distance, const Vector3& normal) {
  return {{{point.x, point.y, point.z}, distance}, normal};
}

// Of a region of the plane and an interval of heights. Outside both, the nearest place is on the
// rim; outside one of them, straight on to it; inside both, whichever is nearer.
Facing of_upright(const NearestEdge& edge, const NearestEnd& end, const Vector3& place) {
  if (edge.distance > 0.0 && end.distance > 0.0) {
    const double distance = std::sqrt(edge.distance * edge.distance + end.distance * end.distance);
    const double across = edge.distance / distance;
    return facing(
        {edge.point.x, edge.point.y, end.at}, distance,
        {edge.normal.x * across, edge.normal.y * across, end.normal * (end.distance / distance)});
  }
  if (edge.distance >= end.distance) {
    return facing({edge.point.x, edge.point.y, place.z}, edge.distance,
                  {edge.normal.x, edge.normal.y, 0.0});
  }
  return facing({place.x, place.y, end.at}, end.distance, {0.0, 0.0, end.normal});
}

NearestEdge nearest_of_circle(const Corner& center, double radius, const Corner& place) {
  const double far = distance_between(place, center);
  const Corner normal = far > kInTheCenter
                            ? Corner{(place.x - center.x) / far, (place.y - center.y) / far}
                            : Corner{1.0, 0.0};
  return {{center.x + normal.x * radius, center.y + normal.y * radius}, far - radius, normal};
}

struct FacingOf {
  const Vector3& place;

  Facing operator()(const Sphere& sphere) const {
    const Vector3 center = vector_of(sphere.center);
    const Vector3 from_center = place - center;
    const double far = length(from_center);
    const Vector3 normal = far > kInTheCenter ? from_center * (1.0 / far) : Vector3{1.0, 0.0, 0.0};
    return facing(center + normal * sphere.radius_m, far - sphere.radius_m, normal);
  }

  Facing operator()(const Box& box) const {
    const Vector3 point{std::clamp(place.x, box.low.x, box.high.x),
                        std::clamp(place.y, box.low.y, box.high.y),
                        std::clamp(place.z, box.low.z, box.high.z)};
    const Vector3 between = place - point;
    const double distance = length(between);
    if (distance > kInTheCenter) return facing(point, distance, between * (1.0 / distance));
    return from_inside(box);
  }

  Facing operator()(const Ground& ground) const {
    return facing({place.x, place.y, ground.height_m}, place.z - ground.height_m, {0.0, 0.0, 1.0});
  }

  Facing operator()(const UprightCylinder& cylinder) const {
    return of_upright(
        nearest_of_circle({cylinder.x, cylinder.y}, cylinder.radius_m, {place.x, place.y}),
        nearest_end(cylinder.heights, place.z), place);
  }

  Facing operator()(const Prism& prism) const {
    return of_upright(prism.outline.nearest({place.x, place.y}),
                      nearest_end(prism.heights, place.z), place);
  }

 private:
  // To the nearest of the six faces.
  [[nodiscard]] Facing from_inside(const Box& box) const {
    const NearestEnd x = nearest_end({box.low.x, box.high.x}, place.x);
    const NearestEnd y = nearest_end({box.low.y, box.high.y}, place.y);
    const NearestEnd z = nearest_end({box.low.z, box.high.z}, place.z);
    if (x.distance >= y.distance && x.distance >= z.distance) {
      return facing({x.at, place.y, place.z}, x.distance, {x.normal, 0.0, 0.0});
    }
    if (y.distance >= z.distance) {
      return facing({place.x, y.at, place.z}, y.distance, {0.0, y.normal, 0.0});
    }
    return facing({place.x, place.y, z.at}, z.distance, {0.0, 0.0, z.normal});
  }
};

struct SolidOf {
  Solid operator()(const UprightPrism& prism) const {
    return Prism{Outline(without_closing_corner(prism.outline)), prism.heights};
  }
  template <class Plain>
  Solid operator()(const Plain& plain) const {
    return plain;
  }
};

struct SizeOf {
  double operator()(const Sphere& sphere) const {
    const auto& [x, y, z] = sphere.center;
    return std::abs(x) + std::abs(y) + std::abs(z) + sphere.radius_m;
  }
  // Each coordinate is one of the place, or an end.
  double operator()(const Box&) const { return 0.0; }
  double operator()(const Ground&) const { return 0.0; }
  double operator()(const UprightCylinder& cylinder) const {
    return std::abs(cylinder.x) + std::abs(cylinder.y) + cylinder.radius_m;
  }
  double operator()(const Prism& prism) const {
    double x = 0.0;
    double y = 0.0;
    for (const Corner& corner : prism.outline.corners()) {
      x = std::max(x, std::abs(corner.x));
      y = std::max(y, std::abs(corner.y));
    }
    return x + y;
  }
};

// Wider by `more`.
struct ExtentOf {
  double more;

  Extent operator()(const Sphere& sphere) const {
    const auto& [x, y, z] = sphere.center;
    const double reach = sphere.radius_m + more;
    return {{x - reach, y - reach, z - reach}, {x + reach, y + reach, z + reach}};
  }

  Extent operator()(const Box& box) const { return {vector_of(box.low), vector_of(box.high)}; }

  Extent operator()(const Ground& ground) const {
    return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, ground.height_m}};
  }

  Extent operator()(const UprightCylinder& cylinder) const {
    const auto& [x, y, radius, heights] = cylinder;
    const double reach = radius + more;
    return {{x - reach, y - reach, heights.low_m}, {x + reach, y + reach, heights.high_m}};
  }

  Extent operator()(const Prism& prism) const {
    Corner low{kInfinity, kInfinity};
    Corner high{-kInfinity, -kInfinity};
    for (const Corner& corner : prism.outline.corners()) {
      low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
      high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    return {{low.x - more, low.y - more, prism.heights.low_m},
            {high.x + more, high.y + more, prism.heights.high_m}};
  }
};

}  // namespace

Solid solid_of(const Obstacle& obstacle) {
  return std::visit(SolidOf{}, obstacle);
}

Facing facing_of(const Solid& solid, const Vector3& place) {
  return std::visit(FacingOf{place}, solid);
}

double size_of(const Solid& solid) {
  return std::visit(SizeOf{}, solid);
}

Extent extent_of(const Solid& solid) {
  return std::visit(ExtentOf{0x1p-49 * size_of(solid)}, solid);
}

}  // namespace beespace::obstacles
