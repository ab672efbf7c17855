#include "obstacles/convex_piece.hpp"

#include "obstacles/convex_parts.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace beespace::obstacles {

namespace {

// Zero times infinity is no number, so an end that is not looked at must not be multiplied.
double support_of(const Heights& heights, double normal) {
  if (normal > 0.0) return normal * heights.high_m;
  if (normal < 0.0) return normal * heights.low_m;
  return 0.0;
}

struct Support {
  const Vector3& normal;

  double operator()(const Sphere& sphere) const {
    return dot(normal, vector_of(sphere.center)) + sphere.radius_m * length(normal);
  }

  double operator()(const Box& box) const {
    return support_of({box.low.x, box.high.x}, normal.x) +
           support_of({box.low.y, box.high.y}, normal.y) +
           support_of({box.low.z, box.high.z}, normal.z);
  }

  double operator()(const Ground& ground) const {
    if (normal.x != 0.0 || normal.y != 0.0) return kInfinity;
    return support_of({-kInfinity, ground.height_m}, normal.z);
  }

  double operator()(const UprightCylinder& cylinder) const {
    const double across = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    return normal.x * cylinder.x + normal.y * cylinder.y + cylinder.radius_m * across +
           support_of(cylinder.heights, normal.z);
  }

  double operator()(const Prism& prism) const {
    double farthest = -kInfinity;
    for (const Corner& corner : prism.outline.corners()) {
      farthest = std::max(farthest, normal.x * corner.x + normal.y * corner.y);
    }
    return farthest + support_of(prism.heights, normal.z);
  }
};

}  // namespace

double ConvexPiece::support(const Vector3& normal) const {
  return std::visit(Support{normal}, solid_);
}

void append_pieces(const Solid& solid, std::size_t obstacle, std::vector<ConvexPiece>& pieces) {
  const auto* prism = std::get_if<Prism>(&solid);
  if (prism == nullptr) {
    pieces.emplace_back(solid, obstacle);
    return;
  }
  for (Outline& part : convex_parts(prism->outline)) {
    pieces.emplace_back(Prism{std::move(part), prism->heights}, obstacle);
  }
}

}  // namespace beespace::obstacles
