// Up to four points, and the point of their convex hull that is closest to the origin: the core of
// the search for the closest points of convex sets.
//
// Gilbert, Johnson, Keerthi: A fast procedure for computing the distance between complex objects in
// three-dimensional space (1988).
#pragma once

#include "base/vector3.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace beespace::avoidance {

using core::Vector3;

class Simplex {
 public:
  void start(const Vector3& corner) { corners_[0] = corner, size_ = 1; }
  // Adds a corner to at most three; false if it is one already.
  bool add(const Vector3& corner);
  // The closest point to the origin. Keeps the corners that it depends on: all four where the
  // origin lies inside.
  Vector3 closest();

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<const Vector3> corners() const { return {corners_.data(), size_}; }

 private:
  void keep(std::initializer_list<Vector3> corners);
  Vector3 on_edge();
  Vector3 on_triangle();
  Vector3 in_tetrahedron();

  std::array<Vector3, 4> corners_{};
  std::size_t size_ = 0;
};

}  // namespace beespace::avoidance
