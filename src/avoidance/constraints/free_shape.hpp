// What must stay free around an agent, as a convex set around the origin: how far it reaches along
// a direction (its support function), and where.
#pragma once

#include "base/vector3.hpp"

#include <beespace/separation.hpp>

#include <algorithm>
#include <cmath>

namespace beespace::avoidance {

using core::Vector3;

class FreeShape {
 public:
  FreeShape() = default;
  // Agents that all have one height see a circle, whatever the shape.
  FreeShape(const Separation& separation, bool planar)
      : shape_(planar ? SeparationShape::kSphere : separation.shape),
        factor_(shape_ == SeparationShape::kEllipsoid ? separation.vertical_factor : 1.0),
        vertical_m_(shape_ == SeparationShape::kCylinder ? separation.vertical_m : 0.0) {}

  [[nodiscard]] bool is_sphere() const { return shape_ == SeparationShape::kSphere; }
  [[nodiscard]] bool is_ellipsoid() const { return shape_ == SeparationShape::kEllipsoid; }
  [[nodiscard]] bool is_cylinder() const { return shape_ == SeparationShape::kCylinder; }
  // Of an ellipsoid; of others 1.
  [[nodiscard]] double vertical_factor() const { return factor_; }

  // How far it reaches along a direction of length 1, with this horizontal semi-axis.
  [[nodiscard]] double support(double horizontal_m, const Vector3& n) const {
    if (is_sphere()) return horizontal_m;
    if (is_ellipsoid()) return horizontal_m * length(Vector3{n.x, n.y, factor_ * n.z});
    return horizontal_m * std::sqrt(n.x * n.x + n.y * n.y) + vertical_m_ * std::abs(n.z);
  }
  // Its point that is farthest along a direction of length 1.
  [[nodiscard]] Vector3 farthest(double horizontal_m, const Vector3& n) const {
    if (is_sphere()) return n * horizontal_m;
    if (is_ellipsoid()) {
      const Vector3 stretched{n.x, n.y, factor_ * n.z};
      const double share = horizontal_m / length(stretched);
      return {share * n.x, share * n.y, share * factor_ * factor_ * n.z};
    }
    const double level = std::sqrt(n.x * n.x + n.y * n.y);
    const double share = level > 0.0 ? horizontal_m / level : 0.0;
    return {share * n.x, share * n.y, std::copysign(vertical_m_, n.z)};
  }
  // How far it reaches at most, along any direction; and for each metre of the semi-axis.
  [[nodiscard]] double widest(double horizontal_m) const {
    return is_cylinder() ? std::sqrt(horizontal_m * horizontal_m + vertical_m_ * vertical_m_)
                         : horizontal_m * growth();
  }
  [[nodiscard]] double growth() const { return std::max(1.0, factor_); }

 private:
  SeparationShape shape_ = SeparationShape::kSphere;
  double factor_ = 1.0;
  double vertical_m_ = 0.0;
};

}  // namespace beespace::avoidance
