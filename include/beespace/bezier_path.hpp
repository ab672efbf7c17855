// Curved paths, as drone shows have them: Bézier pieces, one behind the other.
//
// Units: metres and seconds. Within a piece the curve's parameter runs evenly with time. Source of
// the curve: de Casteljau; of the bound on a chord's deviation: the second differences of its
// control points.
#pragma once

#include <beespace/export.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace beespace {

// From where the piece before it ended to `end`.
struct BezierPiece {
  double ends_s = 0.0;
  Point end;
  std::array<Point, 2> controls{};  // the inner control points, of which the first
  std::uint8_t control_count = 0;   // so many count: 0 a straight line, 1 a quadratic, 2 a cubic
};

struct BezierPath {
  double begins_s = 0.0;
  Point begin;
  std::vector<BezierPiece> pieces;  // of ascending times
};

// The path as fixes with straight lines between them, each less than `tolerance_m` away from the
// curve at every instant; the track's own tolerance says so. Straight pieces cost nothing and are
// exact: a path of nothing else has a tolerance of 0.
//
// Errors: kInvalidArgument for a tolerance that is not above zero, or so small that more than a
// million fixes would be needed for a piece; kTimeOrder; kNotFinite and kOutsideDomain, each with
// the piece in place.record.
BEESPACE_API Result<Track> to_track(const BezierPath& path, double tolerance_m = 0.001);

}  // namespace beespace
