#include <beespace/verify_path.hpp>

#include "motion/bezier_curve.hpp"
#include "motion/paths/exact_closeness.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace beespace {
namespace {

using motion::BezierCurve;
using Controls = std::array<Point, 4>;

// Of the threshold: how exactly the closest distance is known.
constexpr double kTolerance = 1e-9;

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

double length(const Point& a) {
  return std::sqrt(dot(a, a));
}

Point between(const Point& p, const Point& q, double share) {
  return {p.x + (q.x - p.x) * share, p.y + (q.y - p.y) * share, p.z + (q.z - p.z) * share};
}

// As a curve of third degree.
Controls cubic(const BezierCurve& curve) {
  const auto& p = curve.points;
  if (curve.degree == 1) {
    return {p[0], between(p[0], p[1], 1.0 / 3.0), between(p[0], p[1], 2.0 / 3.0), p[1]};
  }
  if (curve.degree == 2) {
    return {p[0], between(p[0], p[1], 2.0 / 3.0), between(p[2], p[1], 2.0 / 3.0), p[2]};
  }
  return p;
}

// The part of it in the window, by its blossom.
Controls part_of(const BezierCurve& curve, const TimeSpan& window) {
  const Controls whole = cubic(curve);
  const double lasts_s = curve.ends_s - curve.begins_s;
  if (!(lasts_s > 0.0)) return whole;
  const std::array<double, 2> shares = {(window.begins_s - curve.begins_s) / lasts_s,
                                        (window.ends_s - curve.begins_s) / lasts_s};
  Controls part{};
  for (std::size_t k = 0; k < 4; ++k) {
    Controls points = whole;
    for (std::size_t step = 0; step < 3; ++step) {
      const double share = shares[step < k ? 1 : 0];
      for (std::size_t i = 0; i + step < 3; ++i) {
        points[i] = between(points[i], points[i + 1], share);
      }
    }
    part[k] = points[0];
  }
  return part;
}

double largest_coordinate(const BezierCurve& curve) {
  double largest = 0.0;
  for (unsigned k = 0; k <= curve.degree; ++k) {
    const Point& p = curve.points[k];
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return largest;
}

// What a window has: no point of the curve is closer than `least_m`, and the nearest that was seen
// is `nearest_m` away, but for rounding.
struct Closeness {
  double least_m;
  double nearest_m;
  double nearest_s;
};

class WindowSearch {
 public:
  // What is not closer than `known_m` need not be looked at closely.
  Closeness operator()(const Controls& curve, const TimeSpan& window, double known_m,
                       double tolerance_m) {
    found_ = {known_m, length(curve[0]), window.begins_s};
    see(curve[3], window.ends_s);
    double least_m = found_.nearest_m;
    open_.assign(1, {curve, window});
    while (!open_.empty()) {
      const Part next = open_.back();
      open_.pop_back();
      const double hull_m = least_of_hull(next.curve);
      if (hull_m >= std::min(least_m, known_m)) {
        least_m = std::min(least_m, std::max(hull_m, known_m));
        continue;
      }
      // The second: where doubles cannot tell halves from wholes.
      if (hull_m >= found_.nearest_m - tolerance_m || open_.size() > kDeepest) {
        least_m = std::min(least_m, hull_m);
        continue;
      }
      halve(next);
    }
    found_.least_m = least_m;
    return found_;
  }

 private:
  static constexpr std::size_t kDeepest = 60;
  struct Part {
    Controls curve;
    TimeSpan time;
  };

  // Along the direction of the middle no point of the hull is below this.
  static double least_of_hull(const Controls& c) {
    const Point middle = between(between(c[0], c[3], 0.5), between(c[1], c[2], 0.5), 0.5);
    const double far_m = length(middle);
    if (!(far_m > 0.0)) return 0.0;
    double least = dot(c[0], middle);
    for (const Point& p : c) least = std::min(least, dot(p, middle));
    return std::max(0.0, least / far_m * (1.0 - 0x1p-48));
  }

  void see(const Point& at, double time_s) {
    const double far_m = length(at);
    if (far_m >= found_.nearest_m) return;
    found_.nearest_m = far_m;
    found_.nearest_s = time_s;
  }

  void halve(const Part& part) {
    const Controls& c = part.curve;
    const Point ab = between(c[0], c[1], 0.5);
    const Point bc = between(c[1], c[2], 0.5);
    const Point cd = between(c[2], c[3], 0.5);
    const Point abc = between(ab, bc, 0.5);
    const Point bcd = between(bc, cd, 0.5);
    const Point middle = between(abc, bcd, 0.5);
    const double half_s = 0.5 * (part.time.begins_s + part.time.ends_s);
    see(middle, half_s);
    open_.push_back({{c[0], ab, abc, middle}, {part.time.begins_s, half_s}});
    open_.push_back({{middle, bcd, cd, c[3]}, {half_s, part.time.ends_s}});
  }

  Closeness found_{};
  std::vector<Part> open_;
};

// Window after window.
class PathSearch {
 public:
  explicit PathSearch(double threshold_m) : threshold_m_(threshold_m) {}

  void look(const BezierCurve& first, const BezierCurve& second, const TimeSpan& window) {
    // Of shares of the time, of control points by themselves and of their halves.
    const double rounded_m = 0x1p-46 * (largest_coordinate(first) + largest_coordinate(second));
    const Controls a = part_of(first, window);
    const Controls b = part_of(second, window);
    Controls apart{};
    for (std::size_t k = 0; k < 4; ++k) {
      apart[k] = {a[k].x - b[k].x, a[k].y - b[k].y, a[k].z - b[k].z};
    }
    const double known_m =
        encounter_ ? std::max(nearest_m_, threshold_m_ + 2.0 * rounded_m) : kFar_m;
    const Closeness found = search_(apart, window, known_m, kTolerance * threshold_m_);
    take(found, rounded_m);
    PathEncounter& encounter = *encounter_;
    if (encounter.closer || found.least_m - rounded_m >= threshold_m_) return;
    encounter.closer = found.nearest_m + rounded_m < threshold_m_ ||
                       motion::closer_exactly(first, second, window, threshold_m_);
  }

  [[nodiscard]] const std::optional<PathEncounter>& encounter() const { return encounter_; }

 private:
  static constexpr double kFar_m = std::numeric_limits<double>::infinity();

  void take(const Closeness& found, double rounded_m) {
    const double least_m = std::max(0.0, found.least_m - rounded_m);
    if (!encounter_) encounter_ = PathEncounter{false, least_m, found.nearest_s};
    encounter_->closest_m = std::min(encounter_->closest_m, least_m);
    if (found.nearest_m >= nearest_m_) return;
    nearest_m_ = found.nearest_m;
    encounter_->closest_s = found.nearest_s;
  }

  double threshold_m_;
  double nearest_m_ = kFar_m;
  std::optional<PathEncounter> encounter_;
  WindowSearch search_;
};

// Of a path without pieces: it is there for an instant.
BezierCurve piece_of(const BezierPath& path, std::size_t piece) {
  if (!path.pieces.empty()) return motion::curve_of(path, piece);
  BezierCurve instant;
  instant.points = {path.begin, path.begin};
  instant.begins_s = instant.ends_s = path.begins_s;
  return instant;
}

// The first piece that is not over at that time.
std::size_t first_piece(const BezierPath& path, double time_s) {
  const auto at = std::find_if(path.pieces.begin(), path.pieces.end(),
                               [&](const BezierPiece& piece) { return piece.ends_s >= time_s; });
  return static_cast<std::size_t>(at - path.pieces.begin());
}

}  // namespace

Result<std::optional<PathEncounter>> closest_on_paths(const BezierPath& first,
                                                      const BezierPath& second,
                                                      const TimeSpan& during, double threshold_m) {
  if (auto error = motion::check_separation(threshold_m, std::nullopt)) return *std::move(error);
  if (auto error = motion::check_bezier_path(first)) return *std::move(error);
  if (auto error = motion::check_bezier_path(second)) return *std::move(error);
  const std::size_t first_count = std::max<std::size_t>(1, first.pieces.size());
  const std::size_t second_count = std::max<std::size_t>(1, second.pieces.size());
  std::size_t i = first_piece(first, during.begins_s);
  std::size_t k = first_piece(second, during.begins_s);
  PathSearch search(threshold_m);
  while (i < first_count && k < second_count) {
    const BezierCurve one = piece_of(first, i);
    const BezierCurve other = piece_of(second, k);
    const TimeSpan window{std::max({one.begins_s, other.begins_s, during.begins_s}),
                          std::min({one.ends_s, other.ends_s, during.ends_s})};
    if (std::max(one.begins_s, other.begins_s) > during.ends_s) break;
    if (window.begins_s <= window.ends_s) search.look(one, other, window);
    if (one.ends_s <= other.ends_s) ++i;
    if (other.ends_s <= one.ends_s) ++k;
  }
  return search.encounter();
}

}  // namespace beespace
