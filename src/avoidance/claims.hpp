// The claims of all agents: the convex hull of the stopping segment and of all places where an
// agent may be if nothing more is told to it.
#pragma once

#include "avoidance/agent_state.hpp"
#include "avoidance/constraints/free_shape.hpp"
#include "avoidance/constraints/hull_separation.hpp"

#include <beespace/advise.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace beespace::avoidance {

// A ball that contains a claim.
struct Enclosing {
  Vector3 middle;
  double half_m;
};

class Claims {
 public:
  // Begins anew. `claims` has one for each agent, or none.
  void start(std::size_t agents, std::span<const Claim> claims, const AdviseOptions& options);
  // Takes the claim of one agent: different ones at the same time, too.
  Enclosing take(std::size_t bee, const Segment& to_stop);

  // Whether claims, tubes, shapes or planar motion make a difference: otherwise there is nothing
  // here, and stopping segments are all there is.
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] Hull hull(std::size_t bee) const {
    return {std::span(points_).subspan(begins_[bee], begins_[bee + 1] - begins_[bee]), axes_[bee],
            beside_m_[bee]};
  }
  [[nodiscard]] bool holds(std::size_t bee) const { return any_ && given(bee).holds; }
  [[nodiscard]] double tube_m(std::size_t bee) const { return any_ ? given(bee).tube_m : 0.0; }
  // Of both tubes.
  [[nodiscard]] double tubes_m(std::size_t bee, std::size_t other) const {
    return tube_m(bee) + tube_m(other);
  }

  [[nodiscard]] const FreeShape& shape() const { return shape_; }
  [[nodiscard]] bool planar() const { return planar_; }
  // What must stay free between two, the uncertainty of both included.
  [[nodiscard]] FreeBetween between(std::size_t bee, std::size_t other) const {
    return {shape_, std::max(threshold_m_, given(bee).radius_m + given(other).radius_m),
            given(bee).tube_m + given(other).tube_m + twice_uncertain_m_, planar_};
  }
  // What must stay free in any direction between an agent and one of which no radius is known: it
  // counts as half of the threshold.
  [[nodiscard]] double from_stranger_m(std::size_t bee) const {
    const double horizontal_m = std::max(threshold_m_, given(bee).radius_m + 0.5 * threshold_m_);
    return shape_.widest(horizontal_m) + given(bee).tube_m + twice_uncertain_m_;
  }
  // How much more than the threshold may have to stay free because of one agent.
  [[nodiscard]] double widens_m(std::size_t bee) const {
    if (!any_) return 0.0;
    return given(bee).tube_m +
           shape_.growth() * std::max(0.0, given(bee).radius_m - 0.5 * threshold_m_);
  }

 private:
  [[nodiscard]] const Claim& given(std::size_t bee) const {
    return claims_.empty() ? kNone : claims_[bee];
  }

  static constexpr Claim kNone = {};

  bool any_ = false;
  std::span<const Claim> claims_;
  FreeShape shape_;
  bool planar_ = false;
  double threshold_m_ = 0.0;
  double twice_uncertain_m_ = 0.0;
  std::vector<std::size_t> begins_;  // of the points of each, and of none behind the last
  std::vector<Vector3> points_;
  std::vector<Segment> axes_;
  std::vector<double> beside_m_;
};

}  // namespace beespace::avoidance
