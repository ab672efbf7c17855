#include "obstacles/validate.hpp"

#include "exact/validate.hpp"
#include "obstacles/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <variant>

namespace beespace::obstacles {

namespace {

using core::shown;

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message), {}};
}

bool in_motion_domain(double value) {
  const double magnitude = std::abs(value);
  return magnitude <= kLargestInMotion && (magnitude >= kSmallestInMotion || magnitude == 0.0);
}

std::optional<Error> check_number(double value, const std::string& name, const char* unit = "m") {
  if (in_motion_domain(value)) return std::nullopt;
  if (!std::isfinite(value)) {
    return Error{
        ErrorCode::kNotFinite, name + " is " + shown(value) + "; it must be a finite number", {}};
  }
  return Error{ErrorCode::kOutsideDomain,
               name + " is " + shown(value) + " " + unit +
                   ", outside the motion domain (0, or 7.9e-31 to 1.3e+30 in magnitude); scale "
                   "the units",
               {}};
}

std::optional<Error> check_vector(double x, double y, double z, const std::string& name,
                                  const char* unit = "m") {
  if (auto error = check_number(x, name + " x", unit)) return error;
  if (auto error = check_number(y, name + " y", unit)) return error;
  return check_number(z, name + " z", unit);
}

std::optional<Error> check_point(const Point& point, const std::string& name) {
  return check_vector(point.x, point.y, point.z, name);
}

std::optional<Error> check_radius(double radius_m) {
  if (auto error = check_number(radius_m, "the radius")) return error;
  if (radius_m >= 0.0) return std::nullopt;
  return invalid("the radius is " + shown(radius_m) + " m; give zero or more");
}

std::optional<Error> check_heights(const Heights& heights) {
  for (const double height : {heights.low_m, heights.high_m}) {
    if (std::isinf(height)) continue;
    if (auto error = check_number(height, "a height")) return error;
  }
  if (heights.low_m < heights.high_m) return std::nullopt;
  return invalid("the heights go from " + shown(heights.low_m) + " m to " + shown(heights.high_m) +
                 " m; give a lower end, and a higher one above it");
}

std::optional<Error> check_outline(std::span<const Corner> outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::string name = "corner " + std::to_string(i);
    if (auto error = check_number(outline[i].x, name + " x")) return error;
    if (auto error = check_number(outline[i].y, name + " y")) return error;
  }
  const auto corners = without_closing_corner(outline);
  if (corners.size() < 3) {
    return invalid("the outline has " + std::to_string(corners.size()) +
                   " corners; give three or more");
  }
  const auto same = [](const Corner& a, const Corner& b) { return a.x == b.x && a.y == b.y; };
  const auto twice = std::adjacent_find(outline.begin(), outline.end(), same);
  if (twice != outline.end()) {
    const auto first = twice - outline.begin();
    return invalid("corners " + std::to_string(first) + " and " + std::to_string(first + 1) +
                   " of the outline are at one place; give it once");
  }
  if (all_on_one_line(corners)) {
    return invalid(
        "the outline encloses nothing, as its corners lie on one line; give three that "
        "do not");
  }
  if (const auto crossing = first_crossing(corners)) {
    return invalid("the outline crosses or touches itself: its edges from corner " +
                   std::to_string(crossing->first) + " and from corner " +
                   std::to_string(crossing->second) + " meet; give the corners in their order");
  }
  return std::nullopt;
}

struct Check {
  std::optional<Error> operator()(const Sphere& sphere) const {
    if (auto error = check_point(sphere.center, "the center")) return error;
    return check_radius(sphere.radius_m);
  }

  std::optional<Error> operator()(const Box& box) const {
    if (auto error = check_point(box.low, "the lowest corner")) return error;
    if (auto error = check_point(box.high, "the highest corner")) return error;
    constexpr const char* kAxisNames[] = {"x", "y", "z"};
    const double low[] = {box.low.x, box.low.y, box.low.z};
    const double high[] = {box.high.x, box.high.y, box.high.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (low[axis] <= high[axis]) continue;
      return invalid(std::string("the box goes from ") + kAxisNames[axis] + " " + shown(low[axis]) +
                     " m to " + shown(high[axis]) + " m; give the lowest corner first");
    }
    return std::nullopt;
  }

  std::optional<Error> operator()(const Ground& ground) const {
    return check_number(ground.height_m, "the height");
  }

  std::optional<Error> operator()(const UprightCylinder& cylinder) const {
    if (auto error = check_number(cylinder.x, "the axis x")) return error;
    if (auto error = check_number(cylinder.y, "the axis y")) return error;
    if (auto error = check_radius(cylinder.radius_m)) return error;
    return check_heights(cylinder.heights);
  }

  std::optional<Error> operator()(const UprightPrism& prism) const {
    if (auto error = check_outline(prism.outline)) return error;
    return check_heights(prism.heights);
  }
};

}  // namespace

std::optional<Error> check(const Obstacle& obstacle) {
  return std::visit(Check{}, obstacle);
}

std::optional<Error> check(const Point& position) {
  return check_point(position, "position");
}

std::optional<Error> check(const Mover& ball, double radius_m, double horizon_s) {
  if (auto error = check(ball.position)) return error;
  const Velocity& v = ball.velocity;
  if (auto error = check_vector(v.x, v.y, v.z, "velocity", "m/s")) return error;
  if (auto error = check_radius(radius_m)) return error;
  if (horizon_s >= 0.0 && in_motion_domain(horizon_s)) return std::nullopt;
  return invalid("the horizon is " + shown(horizon_s) +
                 " s; give a finite time, zero or more (at most 1.3e+30 s)");
}

}  // namespace beespace::obstacles
