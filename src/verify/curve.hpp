// A curve of third degree in space, and how close it gets to the origin at least.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace beespace::verify {

// What is smaller than the motion domain counts as zero where the library's engine is asked.
inline double in_domain(double value) {
  return std::abs(value) < kSmallestInMotion ? 0.0 : value;
}
inline Mover in_domain(const Mover& mover) {
  const auto& [p, v] = mover;
  return {{in_domain(p.x), in_domain(p.y), in_domain(p.z)},
          {in_domain(v.x), in_domain(v.y), in_domain(v.z)}};
}

// Bézier's control points: the curve begins at the first, ends at the last, and never leaves their
// convex hull.
struct Curve {
  std::array<Point, 4> control;
};

inline Point mixed(const Point& a, const Point& b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)};
}
inline double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double length(const Point& a) {
  return std::sqrt(dot(a, a));
}

// The one with these places and velocities at its ends, which lie `lasts_s` apart.
inline Curve curve_of(const Mover& from, const Mover& to, double lasts_s) {
  const double third = lasts_s / 3.0;
  const auto& [p, v] = from;
  const auto& [q, w] = to;
  return {{p,
           {p.x + v.x * third, p.y + v.y * third, p.z + v.z * third},
           {q.x - w.x * third, q.y - w.y * third, q.z - w.z * third},
           q}};
}
// The straight one.
inline Curve line_of(const Point& p, const Point& q) {
  const auto at = [&](double share) {
    return Point{p.x + (q.x - p.x) * share, p.y + (q.y - p.y) * share, p.z + (q.z - p.z) * share};
  };
  return {{p, at(1.0 / 3.0), at(2.0 / 3.0), q}};
}

inline Curve difference(const Curve& a, const Curve& b) {
  Curve curve;
  for (std::size_t k = 0; k < 4; ++k) {
    curve.control[k] = {a.control[k].x - b.control[k].x, a.control[k].y - b.control[k].y,
                        a.control[k].z - b.control[k].z};
  }
  return curve;
}

// Two curves that one after the other are the same.
inline std::array<Curve, 2> halves(const Curve& curve) {
  const auto& c = curve.control;
  const Point ab = mixed(c[0], c[1]);
  const Point bc = mixed(c[1], c[2]);
  const Point cd = mixed(c[2], c[3]);
  const Point abc = mixed(ab, bc);
  const Point bcd = mixed(bc, cd);
  const Point middle = mixed(abc, bcd);
  return {{{{c[0], ab, abc, middle}}, {{middle, bcd, cd, c[3]}}}};
}

// How far from its chord a curve gets at most: three quarters of what its inner control points are
// away from theirs.
inline double bulge_of(const Curve& curve) {
  const Curve off = difference(curve, line_of(curve.control[0], curve.control[3]));
  return 0.75 * std::max(length(off.control[1]), length(off.control[2]));
}

// A distance from the origin that no point of the curve is below; and at most `tolerance` below
// that of the closest. Halves the curve where the hull says too little.
class ClosestToOrigin {
 public:
  double operator()(const Curve& curve, double tolerance) {
    nearest_ = std::min(length(curve.control[0]), length(curve.control[3]));
    double below = nearest_;
    open_.assign(1, curve);
    while (!open_.empty()) {
      const Curve next = open_.back();
      open_.pop_back();
      const double least = least_of_hull(next);
      if (least >= below) continue;
      // The second: where doubles cannot tell halves from wholes.
      if (least >= nearest_ - tolerance || open_.size() > kDeepest) {
        below = std::min(below, least);
        continue;
      }
      halve(next);
    }
    return below;
  }

 private:
  static constexpr std::size_t kDeepest = 60;

  // Along the direction of the middle, no point of the hull is below this.
  double least_of_hull(const Curve& curve) const {
    const auto& c = curve.control;
    const Point middle = mixed(mixed(c[0], c[3]), mixed(c[1], c[2]));
    const double far = length(middle);
    if (!(far > 0.0)) return 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (const Point& p : c) least = std::min(least, dot(p, middle));
    return std::max(0.0, least / far * (1.0 - 0x1p-48));
  }

  void halve(const Curve& curve) {
    for (const Curve& half : halves(curve)) {
      nearest_ = std::min(nearest_, length(half.control[3]));
      open_.push_back(half);
    }
  }

  double nearest_ = 0.0;  // of the points that have been looked at
  std::vector<Curve> open_;
};

// How far from the origin a curve of second degree gets, by its control points: a billionth too
// much at most, never too little.
inline double farthest_from_origin(const std::array<Point, 3>& curve) {
  constexpr double kTolerance = 1e-9;
  constexpr std::size_t kDeepest = 60;
  double reached = std::max(length(curve[0]), length(curve[2]));
  // Evenly accelerated motion is fastest at an end.
  if (length(curve[1]) <= reached) return reached;
  double beyond = reached;
  std::vector<std::array<Point, 3>> open{curve};
  while (!open.empty()) {
    const auto [a, b, c] = open.back();
    open.pop_back();
    const double most = std::max({length(a), length(b), length(c)});
    if (most <= reached * (1.0 + kTolerance) || open.size() > kDeepest) {
      beyond = std::max(beyond, most);
      continue;
    }
    const Point ab = mixed(a, b);
    const Point bc = mixed(b, c);
    const Point middle = mixed(ab, bc);
    reached = std::max(reached, length(middle));
    open.push_back({a, ab, middle});
    open.push_back({middle, bc, c});
  }
  return beyond;
}

}  // namespace beespace::verify
