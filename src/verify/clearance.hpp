// How close to obstacles a curve of third degree gets.
#pragma once

#include "verify/curve.hpp"

#include <beespace/obstacle.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::verify {

// Finds which movers are too close to which obstacles. A curve is as close as its chord, but for
// its bulge; of halves the bulge is a quarter, so a few halvings settle nearly everything.
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
    if (obstacles_.obstacles().empty()) return std::nullopt;
    const double tolerance_m = kTolerance * clearance_m_ + rounded_m;
    open_.assign(1, curve);
    while (!open_.empty()) {
      const Curve next = open_.back();
      open_.pop_back();
      const double bulge_m = bulge_of(next);
      const auto obstacle = touched(next, clearance_m_ + bulge_m + rounded_m);
      if (!obstacle) continue;
      if (bulge_m > 0.25 * tolerance_m && open_.size() < kDeepest) {
        // In the order of time, so that the first obstacle is found first.
        const auto [first, second] = halves(next);
        open_.push_back(second);
        open_.push_back(first);
        continue;
      }
      return Found{*obstacle, closest_seen(curve, next)};
    }
    return std::nullopt;
  }

 private:
  static constexpr double kTolerance = 1e-9;
  static constexpr std::size_t kDeepest = 60;

  // The first obstacle that a ball touches on the way along the chord. Where that cannot be said,
  // beyond the motion domain, it cannot be excluded either: then it is the first of all.
  [[nodiscard]] std::optional<std::size_t> touched(const Curve& curve, double radius_m) const {
    const Point& p = curve.control[0];
    const Point& q = curve.control[3];
    const Mover along = in_domain(Mover{p, {q.x - p.x, q.y - p.y, q.z - p.z}});
    constexpr double kFlushed_m = 0x1p-98;  // what counting as zero may change
    const auto contact = obstacles_.first_contact(along, radius_m + kFlushed_m, 1.0);
    if (!contact) return 0;
    if (!*contact) return std::nullopt;
    return (*contact)->obstacle;
  }

  // For a figure to show: at 64 places of the curve, and of the part of it that is too close.
  [[nodiscard]] double closest_seen(const Curve& curve, const Curve& part) const {
    constexpr int kHalvings = 6;
    double closest_m = std::numeric_limits<double>::infinity();
    for (const Curve& whole : {curve, part}) {
      std::vector<Curve> all{whole};
      for (int k = 0; k < kHalvings; ++k) {
        std::vector<Curve> next;
        for (const Curve& one : all) {
          for (const Curve& half : halves(one)) next.push_back(half);
        }
        all = std::move(next);
      }
      for (const Curve& one : all) {
        for (const Point& p : {one.control[0], one.control[3]}) {
          const auto nearest = obstacles_.nearest(p, closest_m);
          if (nearest) closest_m = nearest->surface.distance_m;
        }
      }
    }
    return closest_m;
  }

  const ObstacleMap& obstacles_;
  double clearance_m_;
  std::vector<Curve> open_;
};

}  // namespace beespace::verify
