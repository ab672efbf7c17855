// Where the middle of a shell is, if points lie on one.
#pragma once

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <optional>

namespace beespace::core {

// The centre of the sphere that fits a sample of the points best, by least squares of |p|^2; none
// where they lie on no sphere of about their own size. `near` is where the centre may be, so that
// what is computed is small.
std::optional<Point> middle_of_shell(const PointsView& points, const Point& near);

}  // namespace beespace::core
