// What a closed line of corners encloses in the plane.
#pragma once

#include <beespace/obstacle.hpp>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace beespace::obstacles {

// Where the edge of a plane region is nearest.
struct NearestEdge {
  Corner point;
  double distance = 0.0;  // below zero inside
  Corner normal;          // of length 1, straight out there; see Facing in solid.hpp
};

inline double distance_between(const Corner& a, const Corner& b) {
  const double x = a.x - b.x;
  const double y = a.y - b.y;
  return std::sqrt(x * x + y * y);
}

// Of a simple outline: counter-clockwise, and without corners that are none because the line goes
// straight on there.
class Outline {
 public:
  // `corners` do not cross or touch themselves (see validate.hpp).
  explicit Outline(std::span<const Corner> corners);

  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }
  [[nodiscard]] bool is_convex() const;
  // Decided exactly, but for the edges themselves, which may be either.
  [[nodiscard]] bool contains(const Corner& place) const;
  [[nodiscard]] NearestEdge nearest(const Corner& place) const;

 private:
  [[nodiscard]] std::size_t before(std::size_t i) const {
    return i == 0 ? corners_.size() - 1 : i - 1;
  }
  [[nodiscard]] std::size_t after(std::size_t i) const {
    return i + 1 == corners_.size() ? 0 : i + 1;
  }
  [[nodiscard]] const Corner& corner_before(std::size_t i) const { return corners_[before(i)]; }

  std::vector<Corner> corners_;
};

}  // namespace beespace::obstacles
