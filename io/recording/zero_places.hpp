// Places that loggers write where they know none: longitude 0 and latitude 0, or -180 and -90,
// exactly. Where others are within a degree of them, they are taken for places all the same.
#pragma once

#include "io/problems/left_out.hpp"

#include <beespace/point.hpp>

#include <cmath>

namespace beespace::io {

inline constexpr LeftOutReason kZeroPlace = {
    "at longitude 0 and latitude 0 exactly, or at -180 and -90, which is written where no place is "
    "known,",
    "the bee was somewhere else then"};

class ZeroPlaces {
 public:
  // A place of the recording, in degrees.
  void look_at(const Point& at) {
    if (is_zero(at) || is_corner(at)) return;
    near_zero_ = near_zero_ || (std::abs(at.x) <= 1.0 && std::abs(at.y) <= 1.0);
    near_corner_ = near_corner_ || at.y <= -89.0;
  }
  // Once all were looked at, or those before it.
  [[nodiscard]] bool is_none(const Point& at) const {
    return (is_zero(at) && !near_zero_) || (is_corner(at) && !near_corner_);
  }

 private:
  static bool is_zero(const Point& at) { return at.x == 0.0 && at.y == 0.0; }
  static bool is_corner(const Point& at) { return at.x == -180.0 && at.y == -90.0; }

  bool near_zero_ = false;
  bool near_corner_ = false;
};

}  // namespace beespace::io
