// A piece of a path of curves by itself, and whether a path is one that can be computed with.
#pragma once

#include <beespace/bezier_path.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <optional>

namespace beespace::motion {

// Control points from end to end; degree + 1 of them count.
struct BezierCurve {
  std::array<Point, 4> points{};
  unsigned degree = 1;
  double begins_s = 0.0;
  double ends_s = 0.0;
};

BezierCurve curve_of(const BezierPath& path, std::size_t piece);

// Errors: those of to_track().
std::optional<Error> check_bezier_path(const BezierPath& path);

}  // namespace beespace::motion
