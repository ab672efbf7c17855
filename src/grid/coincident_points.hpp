// The distinct places of points, where many of them share one.
#pragma once

#include "base/buffer.hpp"
#include "base/resources.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <cstddef>
#include <cstdint>

namespace beespace::core {

class CoincidentPoints {
 public:
  // Working memory: at most 24 bytes a point while it looks for the places; 4 bytes a point and 28
  // a place in the end.
  CoincidentPoints(const PointsView& points, Memory& memory);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] PointsView places() const;
  // How many points are at a place.
  [[nodiscard]] std::uint32_t points_at(std::size_t place) const { return points_at_[place]; }
  [[nodiscard]] const std::uint32_t* points_at() const { return points_at_.data(); }
  [[nodiscard]] std::uint32_t place_of(PointId id) const { return place_of_[id]; }

 private:
  std::size_t size_ = 0;
  Buffer<std::uint32_t> place_of_;
  Buffer<std::uint32_t> points_at_;
  Buffer<Point> places_;
};

}  // namespace beespace::core
