#include "avoidance/constraints/half_spaces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::avoidance {

namespace {

// As a share of the ball's radius: the rounding error of a point in it.
constexpr double kRounding = 1e-12;

// Below this, two planes count as parallel.
constexpr double kParallel = 1e-9;
// Up to this distance outside of it, a point counts as inside a parallel half-space.
constexpr double kNearlyIn = 4.0 * kParallel;

Vector3 into(const Ball& ball, const Vector3& target) {
  return ball.center + at_most(target - ball.center, ball.radius);
}

// On the line where two planes meet: the nearest point within the ball and the other half-spaces.
std::optional<Vector3> on_line(const Vector3& target, const Vector3& point, const Vector3& way,
                               std::span<const HalfSpace> others, const Ball& ball) {
  const Vector3 from_center = point - ball.center;
  const double along = dot(from_center, way);
  const double squared = along * along - dot(from_center, from_center) + ball.radius * ball.radius;
  if (squared < 0.0) return std::nullopt;
  const double root = std::sqrt(squared);
  double low = -along - root;
  double high = -along + root;
  for (const HalfSpace& other : others) {
    const double slope = dot(other.normal, way);
    const double inside = other.inside_by(point);
    if (std::abs(slope) <= kParallel) {
      if (inside < -kNearlyIn * ball.radius) return std::nullopt;
    } else if (slope > 0.0) {
      low = std::max(low, -inside / slope);
    } else {
      high = std::min(high, -inside / slope);
    }
    if (low > high) return std::nullopt;
  }
  return point + way * std::clamp(dot(target - point, way), low, high);
}

// On the plane of a half-space: the nearest point within the ball and the other half-spaces.
std::optional<Vector3> on_plane(const Vector3& target, const HalfSpace& plane,
                                std::span<const HalfSpace> others, const Ball& ball) {
  const double height = -plane.inside_by(ball.center);
  const double squared = ball.radius * ball.radius - height * height;
  if (squared < 0.0) return std::nullopt;
  const Ball disc{ball.center + plane.normal * height, std::sqrt(squared)};
  Vector3 best = into(disc, target - plane.normal * plane.inside_by(target));
  for (std::size_t k = 0; k < others.size(); ++k) {
    const HalfSpace& other = others[k];
    if (other.inside_by(best) >= -kRounding * ball.radius) continue;
    const double cosine = dot(other.normal, plane.normal);
    const Vector3 across = other.normal - plane.normal * cosine;  // on the plane, into the other
    const double sine = length(across);
    if (sine <= kParallel) {
      if (other.inside_by(best) >= -kNearlyIn * ball.radius) continue;
      return std::nullopt;
    }
    // From the centre of the disc to the line, which lies in both planes.
    const Vector3 unit = across * (1.0 / sine);
    const Vector3 point = disc.center - unit * (other.inside_by(disc.center) / sine);
    const auto found = on_line(target, point, cross(plane.normal, unit), others.first(k), ball);
    if (!found) return std::nullopt;
    best = *found;
  }
  return best;
}

}  // namespace

std::optional<Vector3> nearest_place(const Vector3& target, std::span<const HalfSpace> half_spaces,
                                     const Ball& ball) {
  Vector3 best = into(ball, target);
  for (std::size_t k = 0; k < half_spaces.size(); ++k) {
    if (half_spaces[k].inside_by(best) >= -kRounding * ball.radius) continue;
    const auto found = on_plane(target, half_spaces[k], half_spaces.first(k), ball);
    if (!found) return std::nullopt;
    best = *found;
  }
  return best;
}

}  // namespace beespace::avoidance
