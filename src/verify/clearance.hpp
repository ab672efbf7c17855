// How close to obstacles a curve of third degree gets.
#pragma once

#include "verify/curve.hpp"

#include <beespace/obstacle.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace beespace::verify {

// Who is too close to what. A curve is as close as its chord, but for its bulge; of halves the
// bulge is a quarter, so a few halvings settle nearly everything.
class ClearanceCheck {
 public:
  ClearanceCheck(const ObstacleMap& obstacles, double clearance_m)
      : obstacles_(obstacles), clearance_m_(clearance_m) {}

  struct Found {
    std::size_t obstacle;
    double closest_m;
  };
  // Nothing if no point of the curve is closer to an obstacle than the clearance. Curves that come
  // within a billionth of it may count as closer.
  std::optional<Found> operator()(const Curve& curve, double rounded_m) {
    const double tolerance_m = kTolerance * clearance_m_ + rounded_m;
    closest_m_ = std::numeric_limits<double>::infinity();
    std::optional<std::size_t> too_close;
    open_.assign(1, curve);
    while (!open_.empty()) {
      const Curve next = open_.back();
      open_.pop_back();
      const double bulge_m = bulge_of(next);
      const auto obstacle = touched(next, clearance_m_ + bulge_m + rounded_m);
      if (!obstacle) continue;
      look_at(next);
      if (bulge_m > 0.25 * tolerance_m && open_.size() < kDeepest && !(closest_m_ < clearance_m_)) {
        for (const Curve& half : halves(next)) open_.push_back(half);
        continue;
      }
      too_close = too_close.value_or(*obstacle);
      if (closest_m_ < clearance_m_) break;
    }
    if (!too_close) return std::nullopt;
    sample(curve);
    return Found{*too_close, closest_m_};
  }

 private:
  static constexpr double kTolerance = 1e-9;
  static constexpr std::size_t kDeepest = 60;

  // The first obstacle that a ball touches on the way along the chord.
  [[nodiscard]] std::optional<std::size_t> touched(const Curve& curve, double radius_m) const {
    const Point& p = curve.control[0];
    const Point& q = curve.control[3];
    const Mover along{p, {q.x - p.x, q.y - p.y, q.z - p.z}};
    const auto contact = obstacles_.first_contact(along, radius_m, 1.0);
    if (!contact || !*contact) return std::nullopt;
    return (*contact)->obstacle;
  }

  void look_at(const Curve& curve) {
    for (const Point& p : {curve.control[0], curve.control[3]}) {
      const auto nearest = obstacles_.nearest(p, closest_m_);
      if (nearest) closest_m_ = std::min(closest_m_, nearest->surface.distance_m);
    }
  }

  // For a figure to show.
  void sample(const Curve& curve) {
    constexpr int kHalvings = 6;
    std::vector<Curve> all{curve};
    for (int k = 0; k < kHalvings; ++k) {
      std::vector<Curve> next;
      for (const Curve& one : all) {
        for (const Curve& half : halves(one)) next.push_back(half);
      }
      all = std::move(next);
    }
    for (const Curve& one : all) look_at(one);
  }

  const ObstacleMap& obstacles_;
  double clearance_m_;
  double closest_m_ = 0.0;  // of the points that have been looked at
  std::vector<Curve> open_;
};

}  // namespace beespace::verify
