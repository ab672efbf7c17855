#include "avoidance/claims.hpp"

#include "motion/flush.hpp"

#include <algorithm>

namespace beespace::avoidance {

namespace {

// The middle of a box around the points, and the distance of the farthest.
Enclosing ball_around(std::span<const Vector3> points) {
  Vector3 low = points.front();
  Vector3 high = points.front();
  for (const Vector3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vector3 middle = low + (high - low) * 0.5;
  double squared = 0.0;
  for (const Vector3& p : points) squared = std::max(squared, dot(p - middle, p - middle));
  return {middle, std::sqrt(squared)};
}

double farthest_from(const Segment& axis, std::span<const Vector3> points) {
  double squared = 0.0;
  for (const Vector3& p : points) {
    const Vector3 beside = p - axis.closest_to(p);
    squared = std::max(squared, dot(beside, beside));
  }
  return std::sqrt(squared);
}

}  // namespace

void Claims::start(std::size_t agents, std::span<const Claim> claims,
                   const AdviseOptions& options) {
  shape_ = FreeShape(options.separation, options.planar);
  planar_ = options.planar;
  claims_ = claims;
  any_ = !claims.empty() || !shape_.is_sphere() || planar_;
  if (!any_) return;
  threshold_m_ = options.threshold_m;
  twice_uncertain_m_ = 2.0 * options.uncertainty_m;
  begins_.assign(1, 0);
  for (std::size_t bee = 0; bee < agents; ++bee) {
    begins_.push_back(begins_.back() + 2 + given(bee).places.size());
  }
  points_.resize(begins_.back());
  axes_.resize(agents);
  beside_m_.resize(agents);
}

Enclosing Claims::take(std::size_t bee, const Segment& to_stop) {
  const std::span<Vector3> all =
      std::span(points_).subspan(begins_[bee], begins_[bee + 1] - begins_[bee]);
  const std::span<const Point> places = given(bee).places;
  all[0] = to_stop.from;
  all[1] = to_stop.at(1.0);
  std::transform(places.begin(), places.end(), all.begin() + 2,
                 [](const Point& p) { return core::vector_of(motion::flushed(p)); });
  // The first place is usually where the agent is now.
  const Vector3 from = places.empty() ? to_stop.from : all[2];
  axes_[bee] = {from, all[1] - from};
  beside_m_[bee] = farthest_from(axes_[bee], all);
  return ball_around(all);
}

}  // namespace beespace::avoidance
