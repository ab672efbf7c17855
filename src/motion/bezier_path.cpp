#include <beespace/bezier_path.hpp>

#include "motion/bezier_curve.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace beespace {

namespace {

using ControlPoints = std::array<Point, 4>;

constexpr double kMostFixesAPiece = 1e6;

Point between(const Point& p, const Point& q, double share) {
  return {p.x + (q.x - p.x) * share, p.y + (q.y - p.y) * share, p.z + (q.z - p.z) * share};
}

double largest_coordinate(const Point& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

struct Curve : motion::BezierCurve {
  // The greatest distance of the curve from the straight line between its ends, at any time. Their
  // difference vanishes at both ends, and its second derivative is the curve's, at most d (d - 1)
  // max |P[k] - 2 P[k + 1] + P[k + 2]|; so it is at most an eighth of that.
  [[nodiscard]] double bow_m() const {
    double most = 0.0;
    for (unsigned k = 0; k + 2 <= degree; ++k) {
      const Point& a = points[k];
      const Point& b = points[k + 1];
      const Point& c = points[k + 2];
      const double x = (a.x - b.x) + (c.x - b.x);
      const double y = (a.y - b.y) + (c.y - b.y);
      const double z = (a.z - b.z) + (c.z - b.z);
      most = std::max(most, std::sqrt(x * x + y * y + z * z));
    }
    return degree * (degree - 1) / 8.0 * most;
  }

  // How far a fix may be from the curve: its position and its time are rounded.
  [[nodiscard]] double blur_m() const {
    double largest = 0.0;
    double steepest = 0.0;
    for (unsigned k = 0; k <= degree; ++k) {
      largest = std::max(largest, largest_coordinate(points[k]));
      if (k == 0) continue;
      const Point move{points[k].x - points[k - 1].x, points[k].y - points[k - 1].y,
                       points[k].z - points[k - 1].z};
      steepest = std::max(steepest, degree * 2.0 * largest_coordinate(move));
    }
    const double clock = std::max(std::abs(begins_s), std::abs(ends_s)) / (ends_s - begins_s);
    return 0x1p-48 * largest + 0x1p-50 * clock * steepest;
  }

  // de Casteljau.
  [[nodiscard]] Point at(double share) const {
    ControlPoints p = points;
    for (unsigned left = degree; left > 0; --left) {
      for (unsigned k = 0; k < left; ++k) p[k] = between(p[k], p[k + 1], share);
    }
    return p[0];
  }
};

Error error_at(ErrorCode code, std::size_t piece, std::string message) {
  ErrorLocation location;
  location.array = "pieces";
  location.record = piece;
  return {code, std::move(message), location};
}

std::optional<Error> check_piece(const BezierPiece& piece, double begins_s, std::size_t index) {
  if (piece.control_count > piece.controls.size()) {
    return error_at(
        ErrorCode::kInvalidArgument, index,
        std::to_string(piece.control_count) + " inner control points; a piece has at most 2");
  }
  if (auto error = motion::check_position(piece.end, index)) return error;
  for (unsigned k = 0; k < piece.control_count; ++k) {
    if (auto error = motion::check_position(piece.controls[k], index)) return error;
  }
  if (!motion::in_motion_domain(piece.ends_s)) {
    return error_at(std::isfinite(piece.ends_s) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite,
                    index, "the time of its end must be a finite number of seconds");
  }
  if (piece.ends_s > begins_s) return std::nullopt;
  return error_at(ErrorCode::kTimeOrder, index,
                  "it ends at " + std::to_string(piece.ends_s) + " s, no later than it begins (" +
                      std::to_string(begins_s) + " s)");
}

// Adds fixes between which straight lines stay within the tolerance.
std::optional<Error> flatten(const Curve& curve, std::size_t index, double tolerance_m,
                             Track& track) {
  const double bow_m = curve.bow_m();
  if (bow_m > 0.0) {
    const double blur_m = curve.blur_m();
    const double share_m = 0.9 * tolerance_m;  // the rest is for rounding
    const double wanted = std::ceil(std::sqrt(bow_m / share_m));
    if (!(wanted <= kMostFixesAPiece) || blur_m > 0.05 * tolerance_m) {
      return error_at(ErrorCode::kInvalidArgument, index,
                      "a tolerance of " + std::to_string(tolerance_m) +
                          " m is too fine for this piece; give a larger one");
    }
    const auto count = static_cast<unsigned>(wanted);
    for (unsigned k = 1; k < count; ++k) {
      const double share = k / wanted;
      const double time = curve.begins_s + (curve.ends_s - curve.begins_s) * share;
      track.fixes.push_back({time, curve.at(share)});
    }
    track.tolerance_m =
        std::max(track.tolerance_m, bow_m / (wanted * wanted) * (1.0 + 0x1p-40) + blur_m);
  }
  track.fixes.push_back({curve.ends_s, curve.points[curve.degree]});
  return std::nullopt;
}

}  // namespace

namespace motion {

BezierCurve curve_of(const BezierPath& path, std::size_t piece) {
  const BezierPiece& of = path.pieces[piece];
  const bool first = piece == 0;
  BezierCurve curve;
  curve.degree = of.control_count + 1U;
  curve.begins_s = first ? path.begins_s : path.pieces[piece - 1].ends_s;
  curve.ends_s = of.ends_s;
  curve.points[0] = first ? path.begin : path.pieces[piece - 1].end;
  std::copy_n(of.controls.begin(), of.control_count, curve.points.begin() + 1);
  curve.points[curve.degree] = of.end;
  return curve;
}

std::optional<Error> check_bezier_path(const BezierPath& path) {
  if (auto error = check_position(path.begin, 0)) return error;
  if (!in_motion_domain(path.begins_s)) {
    return error_at(
        std::isfinite(path.begins_s) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite, 0,
        "the time of its beginning must be a finite number of seconds");
  }
  double begins_s = path.begins_s;
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    if (auto error = check_piece(path.pieces[i], begins_s, i)) return error;
    begins_s = path.pieces[i].ends_s;
  }
  return std::nullopt;
}

}  // namespace motion

Result<Track> to_track(const BezierPath& path, double tolerance_m) {
  if (!(tolerance_m > 0.0) || !motion::in_motion_domain(tolerance_m)) {
    return Error{
        ErrorCode::kInvalidArgument,
        "the tolerance is " + std::to_string(tolerance_m) + " m; give a finite distance above zero",
        {}};
  }
  if (auto error = motion::check_bezier_path(path)) return *std::move(error);
  Track track;
  track.fixes.push_back({path.begins_s, path.begin});
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    if (auto error = flatten(Curve{motion::curve_of(path, i)}, i, tolerance_m, track)) {
      return *std::move(error);
    }
  }
  return track;
}

}  // namespace beespace
