// Values that come one after the other, and whether they contradict names that say metres.
#pragma once

#include "io/frames/frame_decision.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace beespace::io {

class FrameWitness {
 public:
  void look_at(std::span<const Point> points) {
    extent_.include(extent_of(points));
    for (const Point& point : points) {
      if (witness_ && !(is_whole(witness_->x) && is_whole(witness_->y))) return;
      witness_ = point;
    }
  }

  // At the end.
  [[nodiscard]] std::optional<Error> contradiction(std::size_t dimensions) const {
    if (!witness_) return std::nullopt;
    return contradiction_to_metres(std::span(&*witness_, 1), extent_, dimensions);
  }

 private:
  static bool is_whole(double value) { return std::floor(value) == value; }

  Extent extent_;
  std::optional<Point> witness_;  // not whole, where any is
};

}  // namespace beespace::io
