#include <beespace/verify_path.hpp>

#include "exact/validate.hpp"
#include "motion/bezier_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using motion::BezierCurve;

// How much a limit may be exceeded, and how exactly peaks are known, for rounding.
constexpr double kBillionth = 1e-9;

double speed_of(const Point& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}
double horizontal_of(const Point& v) {
  return std::sqrt(v.x * v.x + v.y * v.y);
}
double up_of(const Point& v) {
  return v.z;
}
double down_of(const Point& v) {
  return -v.z;
}

Point halfway(const Point& a, const Point& b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)};
}

struct Polygon {
  std::array<Point, 4> points{};
  unsigned degree = 0;
};

struct Greatest {
  double value;
  double share;  // of the way from the beginning to the end
};

// The greatest value that `size`, which is convex, has along a curve. No point of a curve has more
// than the greatest of its control points, and those of its halves come ever closer to it.
template <class Size>
Greatest greatest_along(const Polygon& curve, Size size) {
  struct Part {
    std::array<Point, 4> points;
    double begins;
    double lasts;
  };
  constexpr double kShortest = 0x1p-50;
  const auto most_of = [&](const std::array<Point, 4>& points) {
    double most = size(points[0]);
    for (unsigned k = 1; k <= curve.degree; ++k) most = std::max(most, size(points[k]));
    return most;
  };
  double scale = 0.0;
  for (unsigned k = 0; k <= curve.degree; ++k) {
    scale = std::max(scale, std::abs(size(curve.points[k])));
  }
  Greatest reached{size(curve.points[0]), 0.0};
  const auto see = [&](const Point& point, double share) {
    if (size(point) > reached.value) reached = {size(point), share};
  };
  see(curve.points[curve.degree], 1.0);
  double beyond = reached.value;
  std::vector<Part> open{{curve.points, 0.0, 1.0}};
  while (!open.empty()) {
    const Part part = open.back();
    open.pop_back();
    const double most = most_of(part.points);
    if (most <= reached.value + kBillionth * scale || part.lasts < kShortest) {
      beyond = std::max(beyond, most);
      continue;
    }
    Part left = part;
    Part right = part;
    std::array<Point, 4> points = part.points;
    for (unsigned step = 0; step <= curve.degree; ++step) {
      left.points[step] = points[0];
      right.points[curve.degree - step] = points[curve.degree - step];
      for (unsigned k = 0; k + step < curve.degree; ++k) {
        points[k] = halfway(points[k], points[k + 1]);
      }
    }
    left.lasts = right.lasts = 0.5 * part.lasts;
    right.begins += right.lasts;
    see(right.points[0], right.begins);
    open.push_back(right);
    open.push_back(left);
  }
  return {beyond, reached.share};
}

// The control points of the derivative.
Polygon derivative(const Polygon& curve, double lasts_s) {
  Polygon of;
  if (curve.degree == 0) return of;
  of.degree = curve.degree - 1;
  const double scale = curve.degree / lasts_s;
  for (unsigned k = 0; k < curve.degree; ++k) {
    const Point& a = curve.points[k];
    const Point& b = curve.points[k + 1];
    of.points[k] = {(b.x - a.x) * scale, (b.y - a.y) * scale, (b.z - a.z) * scale};
  }
  return of;
}

// What the path is like in a piece, and what rounding may have made of that.
struct PieceMotion {
  Polygon position;
  Polygon velocity;
  Polygon acceleration;
  double begins_s;
  double ends_s;
  double rounded_m;
  double rounded_mps;
  double rounded_mps2;
};

PieceMotion motion_of(const BezierCurve& curve) {
  PieceMotion motion{};
  motion.position = {curve.points, curve.degree};
  motion.begins_s = curve.begins_s;
  motion.ends_s = curve.ends_s;
  const double lasts_s = curve.ends_s - curve.begins_s;
  motion.velocity = derivative(motion.position, lasts_s);
  motion.acceleration = derivative(motion.velocity, lasts_s);
  double farthest_m = 0.0;
  double fastest_mps = 0.0;
  for (unsigned k = 0; k <= curve.degree; ++k) {
    const Point& p = curve.points[k];
    farthest_m = std::max({farthest_m, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    fastest_mps = std::max(fastest_mps, speed_of(motion.velocity.points[k]));
  }
  // Positions and times were rounded when they were written, by half of their last bit: differences
  // of them are as wrong.
  const double clock_s = std::max(std::abs(curve.begins_s), std::abs(curve.ends_s));
  motion.rounded_m = 0x1p-50 * farthest_m;
  motion.rounded_mps = 4.0 * curve.degree * motion.rounded_m / lasts_s +
                       std::min(1.0, 0x1p-51 * clock_s / lasts_s) * fastest_mps;
  motion.rounded_mps2 = 4.0 * curve.degree * motion.rounded_mps / lasts_s;
  return motion;
}

class PathChecking {
 public:
  explicit PathChecking(const PathLimits& limits) : limits_(limits) {
    for (PathPeak& peak : check_.peaks) peak.value = -std::numeric_limits<double>::infinity();
  }

  void look(const PieceMotion& now) {
    if (before_.ends_s == now.begins_s && seen_) look_at_corner(now);
    look_along(PathLimit::kSpeed, now, now.velocity, speed_of, now.rounded_mps);
    look_along(PathLimit::kHorizontalSpeed, now, now.velocity, horizontal_of, now.rounded_mps);
    look_along(PathLimit::kClimb, now, now.velocity, up_of, now.rounded_mps);
    look_along(PathLimit::kDescent, now, now.velocity, down_of, now.rounded_mps);
    look_along(PathLimit::kAcceleration, now, now.acceleration, speed_of, now.rounded_mps2);
    look_along(PathLimit::kHeight, now, now.position, up_of, now.rounded_m);
    before_ = now;
    seen_ = true;
  }

  void look_at_instant(const Point& place, double time_s) {
    for (std::size_t k = 0; k < kPathLimits; ++k) {
      if (k != static_cast<std::size_t>(PathLimit::kHeight)) check_.peaks[k] = {0.0, time_s};
    }
    note(PathLimit::kHeight, {time_s, time_s}, {place.z, time_s}, 0.0);
  }

  PathCheck result() {
    for (const std::vector<PathExcess>& of : excesses_) {
      check_.excesses.insert(check_.excesses.end(), of.begin(), of.end());
    }
    return std::move(check_);
  }

 private:
  template <class Size>
  void look_along(PathLimit limit, const PieceMotion& now, const Polygon& curve, Size size,
                  double rounded) {
    const Greatest most = greatest_along(curve, size);
    const double at_s =
        most.share < 1.0 ? now.begins_s + (now.ends_s - now.begins_s) * most.share : now.ends_s;
    note(limit, {now.begins_s, now.ends_s}, {most.value, at_s}, rounded);
  }

  // Where the velocity jumps.
  void look_at_corner(const PieceMotion& now) {
    const Point& from = before_.velocity.points[before_.velocity.degree];
    const Point& to = now.velocity.points[0];
    const double jump = speed_of({to.x - from.x, to.y - from.y, to.z - from.z});
    const TimeSpan turn{0.5 * (before_.begins_s + before_.ends_s),
                        0.5 * (now.begins_s + now.ends_s)};
    const double rounded_mps = before_.rounded_mps + now.rounded_mps;
    // Evenly accelerated in a time t, a drone is jump * t / 8 beside the corner when it is closest
    // to it.
    const double within_halves_s = 0.5 * (now.ends_s - before_.begins_s);
    const double near_path_s =
        jump > 0.0 ? 8.0 * kCornerDeviation_m / jump : std::numeric_limits<double>::infinity();
    if (!(near_path_s < within_halves_s)) {
      note(PathLimit::kAcceleration, turn, {jump / within_halves_s, now.begins_s, true},
           rounded_mps / within_halves_s);
      return;
    }
    const TimeSpan sharp{std::max(turn.begins_s, now.begins_s - 0.5 * near_path_s),
                         std::min(turn.ends_s, now.begins_s + 0.5 * near_path_s)};
    const double rounded = (2.0 * jump + rounded_mps) * rounded_mps / (8.0 * kCornerDeviation_m);
    note(PathLimit::kAcceleration, sharp, {jump / near_path_s, now.begins_s, true}, rounded);
  }

  void note(PathLimit limit, const TimeSpan& span, const PathPeak& found, double rounded) {
    const auto which = static_cast<std::size_t>(limit);
    PathPeak& peak = check_.peaks[which];
    if (found.value > peak.value) peak = found;
    if (!(found.value > limits_[limit] * (1.0 + kBillionth) + rounded)) return;
    std::vector<PathExcess>& known = excesses_[which];
    if (known.empty() || known.back().ends_s < span.begins_s) {
      known.push_back({limit, span.begins_s, span.ends_s, found});
      return;
    }
    PathExcess& last = known.back();
    last.begins_s = std::min(last.begins_s, span.begins_s);
    last.ends_s = std::max(last.ends_s, span.ends_s);
    if (found.value > last.peak.value) last.peak = found;
  }

  const PathLimits& limits_;
  PathCheck check_;
  std::array<std::vector<PathExcess>, kPathLimits> excesses_;
  PieceMotion before_{};
  bool seen_ = false;
};

}  // namespace

Result<PathCheck> check_path(const BezierPath& path, const PathLimits& limits) {
  for (const double most : limits.most) {
    if (most >= 0.0) continue;
    return Error{ErrorCode::kInvalidArgument,
                 "a limit is " + core::shown(most) + "; give zero or more, or infinity for none",
                 {}};
  }
  if (auto error = motion::check_bezier_path(path)) return *std::move(error);
  PathChecking checking(limits);
  if (path.pieces.empty()) checking.look_at_instant(path.begin, path.begins_s);
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    checking.look(motion_of(motion::curve_of(path, i)));
  }
  return checking.result();
}

}  // namespace beespace
