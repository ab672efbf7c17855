/// @file
/// @brief Curved paths, as drone shows have them: Bézier curves, one after the other, and their
/// approximation by straight lines.
///
/// Units: metres and seconds. Within a piece the parameter of the curve is linear in time.
///
/// Sources: de Casteljau's algorithm for the curve; the second differences of its control points
/// for the bound on the deviation of a chord.
#pragma once

#include <beespace/export.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace beespace {

/// @brief One Bézier curve of a path: from the end of the piece before it to `end`.
struct BezierPiece {
  double ends_s = 0.0;              ///< When the piece ends, in seconds.
  Point end;                        ///< Where it ends, in metres.
  std::array<Point, 2> controls{};  ///< The inner control points, in metres.
  std::uint8_t control_count = 0;   ///< How many of `controls` count: 0 makes a straight line, 1 a
                                    ///< quadratic curve, 2 a cubic one.
};

/// @brief A path of Bézier curves, one after the other.
struct BezierPath {
  double begins_s = 0.0;            ///< When the path begins, in seconds.
  Point begin;                      ///< Where it begins, in metres.
  std::vector<BezierPiece> pieces;  ///< Its curves, of ascending times.
};

/// @brief Approximates a path by straight lines between fixes.
///
/// At every instant the result is less than `tolerance_m` away from the curve, and
/// Track::tolerance_m says so. Straight pieces are kept as they are: a path of straight pieces
/// alone has a tolerance of 0.
///
/// Complexity: linear in the number of fixes. Thread safety: no state is kept.
///
/// @param path The path, in metres and seconds.
/// @param tolerance_m The largest deviation in metres; above zero.
/// @return The track; or an error, with the piece in ErrorLocation::record:
///   - ErrorCode::kInvalidArgument: a tolerance that is not above zero, or so small that a piece
///     would need more than a million fixes;
///   - ErrorCode::kTimeOrder: a piece that does not end after the one before it;
///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a time or coordinate that is not a number
///     of the motion domain (see mover.hpp).
BEESPACE_API Result<Track> to_track(const BezierPath& path, double tolerance_m = 0.001);

}  // namespace beespace
