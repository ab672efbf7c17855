#include "avoidance/constraints/simplex.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace beespace::avoidance {

namespace {

// The point of the line through a and b that is closest to the origin, from its share of the way;
// at right angles to the line in spite of rounding.
Vector3 on_line(const Vector3& a, const Vector3& way, double share) {
  const Vector3 point = a + way * share;
  return point - way * (dot(point, way) / dot(way, way));
}

}  // namespace

bool Simplex::add(const Vector3& corner) {
  const auto present = corners();
  if (size_ == corners_.size() ||
      std::find(present.begin(), present.end(), corner) != present.end()) {
    return false;
  }
  corners_[size_++] = corner;
  return true;
}

Vector3 Simplex::closest() {
  if (size_ == 1) return corners_[0];
  if (size_ == 2) return on_edge();
  return size_ == 3 ? on_triangle() : in_tetrahedron();
}

void Simplex::keep(std::initializer_list<Vector3> corners) {
  std::copy(corners.begin(), corners.end(), corners_.begin());
  size_ = corners.size();
}

Vector3 Simplex::on_edge() {
  const auto [a, b, c, d] = corners_;
  const Vector3 way = b - a;
  const double along = -dot(a, way);
  const double squared = dot(way, way);
  if (!(along > 0.0)) return keep({a}), a;
  if (along >= squared) return keep({b}), b;
  return on_line(a, way, along / squared);
}

// By the regions that belong to its corners, edges and inside. Ericson: Real-time collision
// detection (2005), 5.1.5.
Vector3 Simplex::on_triangle() {
  const auto [a, b, c, d] = corners_;
  const Vector3 to_b = b - a;
  const Vector3 to_c = c - a;
  const double b_from_a = -dot(to_b, a);
  const double c_from_a = -dot(to_c, a);
  if (b_from_a <= 0.0 && c_from_a <= 0.0) return keep({a}), a;
  const double b_from_b = -dot(to_b, b);
  const double c_from_b = -dot(to_c, b);
  if (b_from_b >= 0.0 && c_from_b <= b_from_b) return keep({b}), b;
  const double for_c = b_from_a * c_from_b - b_from_b * c_from_a;
  if (for_c <= 0.0 && b_from_a >= 0.0 && b_from_b <= 0.0) {
    keep({a, b});
    return on_edge();
  }
  const double b_from_c = -dot(to_b, c);
  const double c_from_c = -dot(to_c, c);
  if (c_from_c >= 0.0 && b_from_c <= c_from_c) return keep({c}), c;
  const double for_b = b_from_c * c_from_a - b_from_a * c_from_c;
  if (for_b <= 0.0 && c_from_a >= 0.0 && c_from_c <= 0.0) {
    keep({a, c});
    return on_edge();
  }
  const double for_a = b_from_b * c_from_c - b_from_c * c_from_b;
  if (for_a <= 0.0 && c_from_b - b_from_b >= 0.0 && b_from_c - c_from_c >= 0.0) {
    keep({b, c});
    return on_edge();
  }
  const Vector3 upright = cross(to_b, to_c);
  const double squared = dot(upright, upright);
  if (!(squared > 0.0)) {
    keep({a, b});
    return on_edge();
  }
  return upright * (dot(upright, a) / squared);
}

// The closest of the faces, unless the origin lies on the inner side of all of them.
Vector3 Simplex::in_tetrahedron() {
  const std::array<Vector3, 4> all = corners_;
  static constexpr std::array<std::array<std::size_t, 4>, 4> kFaces = {
      {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
  bool outside = false;
  Simplex best;
  Vector3 nearest;
  for (const auto& [i, j, k, opposite] : kFaces) {
    const Vector3 upright = cross(all[j] - all[i], all[k] - all[i]);
    const double inner = dot(upright, all[opposite] - all[i]);
    const double origin = -dot(upright, all[i]);
    // A flat one has no inside.
    if (inner != 0.0 && (inner > 0.0) == (origin > 0.0)) continue;
    Simplex face;
    face.keep({all[i], all[j], all[k]});
    const Vector3 point = face.on_triangle();
    if (outside && dot(point, point) >= dot(nearest, nearest)) continue;
    outside = true;
    best = face;
    nearest = point;
  }
  if (!outside) return {};
  *this = best;
  return nearest;
}

}  // namespace beespace::avoidance
