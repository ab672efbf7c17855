/// @file
/// @brief Do curved paths, as drone shows have them, keep their distance and stay within limits?
///
/// Both are decided along the curves themselves (bezier_path.hpp), not on samples of them: the
/// distance of two as real numbers on the given doubles, the greatest speeds, accelerations and
/// heights by bounds that are never below them.
///
/// Units: metres and seconds, z upwards.
///
/// Sources: Bernstein's form of polynomials, which are never below the least of their coefficients,
/// and de Casteljau's halving, which lets these come as close as one likes.
#pragma once

#include <beespace/bezier_path.hpp>
#include <beespace/conflict.hpp>
#include <beespace/export.hpp>
#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace beespace {

/// @brief How close two paths come, and whether that is too close.
struct PathEncounter {
  /// @brief Whether they are closer than the threshold at some instant, as real numbers. Where they
  /// touch exactly the threshold at an instant that no double is, so that this cannot be told from
  /// being closer, it counts as closer.
  bool closer = false;
  double closest_m = 0.0;  ///< Never more than their least distance, and a billionth of the
                           ///< threshold below it at most (beside the rounding of the positions).
  double closest_s = 0.0;  ///< An instant at which they are that close, in seconds.
};

/// @brief Decides how close two paths come in some time.
///
/// Complexity: linear in the pieces of that time. Thread safety: no state is kept.
///
/// @param first The one path.
/// @param second The other path.
/// @param during The time that is looked at, as far as both are there.
/// @param threshold_m Closer than this, in metres, is too close.
/// @return How close; absent where they are not there at the same time; or an error:
///   - ErrorCode::kInvalidThreshold: a threshold that is no number above zero of the motion domain
///     (see mover.hpp);
///   - those of to_track() for the paths.
BEESPACE_API Result<std::optional<PathEncounter>> closest_on_paths(const BezierPath& first,
                                                                   const BezierPath& second,
                                                                   const TimeSpan& during,
                                                                   double threshold_m);

/// @brief What a path may have limits of.
enum class PathLimit : std::uint8_t {
  kSpeed,            ///< The speed, in metres per second.
  kHorizontalSpeed,  ///< The speed in x and y, in metres per second.
  kClimb,            ///< The speed upwards, in metres per second.
  kDescent,          ///< The speed downwards, in metres per second.
  kAcceleration,     ///< The acceleration, in metres per second squared.
  kHeight,           ///< z, in metres.
};

/// @brief How many PathLimit there are.
inline constexpr std::size_t kPathLimits = 6;

/// @brief The limits of a path, by PathLimit; infinite where there is none.
struct PathLimits {
  /// @brief The greatest value of each, in the order of PathLimit.
  std::array<double, kPathLimits> most = {
      std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
      std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
      std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

  /// @brief The limit of one.
  /// @param limit Which.
  /// @return It.
  double& operator[](PathLimit limit) { return most[static_cast<std::size_t>(limit)]; }
  /// @brief The limit of one.
  /// @param limit Which.
  /// @return It.
  double operator[](PathLimit limit) const { return most[static_cast<std::size_t>(limit)]; }
};

/// @brief How far a corner may be cut, in metres: what is taken as being flown on a path.
///
/// Drones of a show hold their places to about so much, and paths that were simplified leave the
/// curves that were meant by less; distances between drones are planned with more room than this.
inline constexpr double kCornerDeviation_m = 0.5;

/// @brief The greatest value of something along a path.
struct PathPeak {
  double value = 0.0;  ///< Never less than it is, and a billionth more at most (beside the rounding
                       ///< of positions and times).
  double at_s = 0.0;   ///< When it is reached, in seconds.
  bool at_corner =
      false;  ///< Of an acceleration: whether it is that of a corner; see check_path().
};

/// @brief A stretch of pieces of a path in each of which a limit is exceeded.
struct PathExcess {
  PathLimit limit = PathLimit::kSpeed;  ///< Which limit.
  double begins_s = 0.0;                ///< When the first of the pieces begins, in seconds; of a
                                        ///< corner, the middle of the piece before it.
  double ends_s = 0.0;                  ///< When the last of the pieces ends, in seconds; of a
                                        ///< corner, the middle of the piece behind it.
  PathPeak peak;                        ///< The greatest value in them.
};

/// @brief What was found along a path.
struct PathCheck {
  std::array<PathPeak, kPathLimits> peaks{};  ///< The greatest values, in the order of PathLimit.
  std::vector<PathExcess> excesses;           ///< In the order of (limit, begins_s).
};

/// @brief Checks a path against limits.
///
/// A value may be above its limit by a billionth, and by what the rounding of positions and times
/// to doubles may have made of it; more is always found. Where one piece goes over into the next
/// with another velocity, no drone can follow exactly: the acceleration there is that which takes
/// the corner within the nearer half of both pieces and within kCornerDeviation_m of the path. Of a
/// jump v of the velocity that is the greater of v / t, with half of their common length t, and of
/// v^2 / (8 kCornerDeviation_m), since evenly accelerated for a time t a drone cuts the corner by
/// v t / 8. So it does not depend on how many points a path was simplified to.
///
/// Complexity: linear in the pieces. Thread safety: no state is kept.
///
/// @param path The path.
/// @param limits The limits; numbers from zero on, or infinite.
/// @return What was found; or an error:
///   - ErrorCode::kInvalidArgument: a limit below zero, or none;
///   - those of to_track() for the path.
BEESPACE_API Result<PathCheck> check_path(const BezierPath& path, const PathLimits& limits);

}  // namespace beespace
