// Points at longitude 0 and latitude 0 exactly, or at the South Pole, among points in metres: what
// is written where no place is known, unless others are within a degree.
#pragma once

#include <beespace/point.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace beespace::io {

class ZeroPoints {
 public:
  // More points, that come from longitudes and latitudes. Which of them may be none: ascending.
  std::vector<std::size_t> look_at(std::span<const Point> ecef);

  // Of one of these, once all were looked at.
  [[nodiscard]] bool is_none(const Point& ecef) const;

 private:
  bool near_zero_ = false;
  bool near_pole_ = false;
};

}  // namespace beespace::io
