#include "exact/exact_distance.hpp"

#include <beespace/nearest.hpp>

#include <cmath>

namespace beespace {

double distance(const Point& a, const Point& b) {
  return std::sqrt(core::squared_distance(a, b));
}

}  // namespace beespace
