#include "exact/exact_distance.hpp"

#include <beespace/nearest.hpp>

namespace beespace {

double distance(const Point& a, const Point& b) {
  return core::rounded_distance(a, b);
}

}  // namespace beespace
