// What the boxes of two sets of points tell about all distances between these.
#pragma once

#include "base/bounds.hpp"
#include "exact/exact_distance.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace beespace::core {

enum class Reach : std::uint8_t { kNear, kOpen, kFar };  // all within the threshold, ?, none

// Exact: where rounding leaves open whether the extreme distances of two boxes are within the
// threshold, the corners at these distances are compared as points are.
class BoxTest {
 public:
  // With the bounds of ProximityTest: the extreme distances of two boxes are rounded just as the
  // distances of points are. The test must outlive this one.
  BoxTest(double threshold, const ProximityTest& closer)
      : closer_(closer),
        surely_near_(threshold * threshold * (1.0 - 0x1p-50)),
        surely_far_(threshold * threshold * (1.0 + 0x1p-50)) {}

  [[nodiscard]] Reach operator()(const Bounds& a, const Bounds& b) const {
    double nearest = 0.0;
    double farthest = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double up = b.high[axis] - a.low[axis];
      const double down = a.high[axis] - b.low[axis];
      const double most = std::max(up, down);
      const double least = std::max(0.0, -std::min(up, down));
      farthest += most * most;
      nearest += least * least;
    }
    if (nearest > surely_far_) return Reach::kFar;
    if (farthest < surely_near_) return Reach::kNear;
    if (nearest >= surely_near_ && !is_nearest_near(a, b)) return Reach::kFar;
    if (farthest <= surely_far_ && is_farthest_near(a, b)) return Reach::kNear;
    return Reach::kOpen;
  }

  // The squares of extreme distances that leave nothing open, below and above.
  [[nodiscard]] double surely_near() const { return surely_near_; }
  [[nodiscard]] double surely_far() const { return surely_far_; }

 private:
  using Corner = std::array<double, 3>;

  [[nodiscard]] bool are_near(const Corner& p, const Corner& q) const {
    return closer_(Point{p[0], p[1], p[2]}, Point{q[0], q[1], q[2]});
  }

  [[nodiscard]] bool is_nearest_near(const Bounds& a, const Bounds& b) const {
    Corner p;
    Corner q;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from = std::max(a.low[axis], b.low[axis]);
      const double to = std::min(a.high[axis], b.high[axis]);
      // They have `from` in common, or it begins the one behind the gap.
      p[axis] = from;
      q[axis] = std::min(from, to);
    }
    return are_near(p, q);
  }

  [[nodiscard]] bool is_farthest_near(const Bounds& a, const Bounds& b) const {
    Corner p;
    Corner q;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double up = b.high[axis] - a.low[axis];
      const double down = a.high[axis] - b.low[axis];
      // Rounding hides which is longer: a little less than this is all that is known.
      if (up == down && (a.low[axis] != b.low[axis] || a.high[axis] != b.high[axis])) return false;
      p[axis] = up >= down ? a.low[axis] : a.high[axis];
      q[axis] = up >= down ? b.high[axis] : b.low[axis];
    }
    return are_near(p, q);
  }

  const ProximityTest& closer_;
  double surely_near_;
  double surely_far_;
};

}  // namespace beespace::core
