/// @file
/// @brief A position in space, and the number by which beespace names it.
///
/// Units: metres, in any Cartesian frame (local, ECEF, ...). Plain values: copy them freely.
#pragma once

#include <cstdint>

/// @brief Exact separation checks for swarms: which points are closer than a threshold, now and
/// soon.
namespace beespace {

/// @brief One position, in metres.
///
/// Each coordinate that is given to a search must lie in the *coordinate domain*: zero, or a
/// magnitude between #kSmallestCoordinate_m and #kLargestCoordinate_m. Inside it no exact
/// square overflows or underflows, which is what the exactness of the answers rests on. NaN and
/// infinities are outside. Exactness also rests on the rounding mode that programs start with, to
/// the nearest double.
struct Point {
  double x = 0.0;  ///< Along the first axis, in metres.
  double y = 0.0;  ///< Along the second axis, in metres.
  double z = 0.0;  ///< Along the third axis, in metres.

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

/// @brief The smallest magnitude above zero of the coordinate domain, about 3.9e-121 m.
inline constexpr double kSmallestCoordinate_m = 0x1p-400;
/// @brief The largest magnitude of the coordinate domain, about 2.6e+120 m.
inline constexpr double kLargestCoordinate_m = 0x1p+400;

/// @brief The 0-based index of a point in the caller's order.
using PointId = std::uint32_t;

/// @brief The most points that one search takes: every id fits a PointId, and so do the indices of
/// a few thousand more, so that loops may count beyond the last.
inline constexpr std::uint64_t kMaxPoints = 0xFFFF'F000u;

}  // namespace beespace
