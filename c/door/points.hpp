// The caller's beespace_points as a view of the C++ library, with all checks that pointers allow.
#pragma once

#include <beespace.h>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <optional>

namespace beespace::c {

// `name` stands in errors: "points", "others", "places".
Result<PointsView> view_of(const beespace_points* points, const char* name);

// The points of one question, and those that they are compared with, where these are others.
struct PointSets {
  PointsView points;
  std::optional<PointsView> others;
};

// Three coordinates, one after the other.
template <class Vector>
void write_three(const Vector& vector, double* into) {
  into[0] = vector.x;
  into[1] = vector.y;
  into[2] = vector.z;
}

// NULL for `others` means none.
Result<PointSets> sets_of(const beespace_points* points, const beespace_points* others);

}  // namespace beespace::c
