#include "exact/validate.hpp"

#include <cmath>
#include <cstdio>
#include <span>
#include <utility>

namespace beespace::core {

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

Error threshold_not_given() {
  return {ErrorCode::kInvalidThreshold,
          "the threshold is not given (or is not a number); say in metres how close is too close",
          {}};
}

std::optional<Error> check_options(const PairOptions& options) {
  const double threshold = options.threshold_m;
  if (threshold > 0.0 && in_domain(threshold)) return std::nullopt;
  if (std::isnan(threshold)) return threshold_not_given();
  return Error{ErrorCode::kInvalidThreshold,
               "the threshold is " + shown(threshold) +
                   " m; give a finite distance above zero (3.9e-121 m to 2.6e+120 m)",
               {}};
}

namespace {

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message), {}};
}

std::optional<Error> check_height_count_of(std::span<const double> heights, std::size_t points,
                                           const char* name) {
  if (heights.size() == points) return std::nullopt;
  Error error = invalid(std::to_string(heights.size()) + " heights for " + std::to_string(points) +
                        " points; give one for each, or none");
  error.location.array = name;
  return error;
}

std::optional<Error> check_heights_of(std::span<const double> heights, std::size_t points,
                                      const char* name) {
  if (auto error = check_height_count_of(heights, points, name)) return error;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double height = heights[i];
    if (in_domain(height)) continue;
    ErrorLocation location;
    location.array = name;
    location.record = i;
    return Error{std::isfinite(height) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite,
                 "the height is " + shown(height) +
                     "; it must be a finite number in the coordinate domain (0, or 3.9e-121 m to "
                     "2.6e+120 m in magnitude)",
                 location};
  }
  return std::nullopt;
}

}  // namespace

// What does not depend on the points: for so many of them in all, of which some may have heights
// that are kept apart. Where there are no points, nor are there heights.
std::optional<Error> check_vertical(const PairOptions& options, std::size_t points, bool apart) {
  if (!options.vertical_m) {
    if (!apart) return std::nullopt;
    return invalid(
        "there are heights apart from the positions, but no vertical threshold to compare them "
        "with; give one, or positions in space");
  }
  const double vertical = *options.vertical_m;
  if (!(vertical > 0.0) || !in_domain(vertical)) {
    return Error{ErrorCode::kInvalidThreshold,
                 "the vertical threshold is " + shown(vertical) +
                     " m; give a finite distance above zero (3.9e-121 m to 2.6e+120 m)",
                 {}};
  }
  if (!(options.height_unit_m >= 1e-6) || !(options.height_unit_m <= 1e6)) {
    return invalid("the unit of heights is " + shown(options.height_unit_m) +
                   " m; give how many metres one is (0.3048 for feet), from 1e-6 to 1e6");
  }
  if (!apart && points > 0 && options.height_unit_m != 1.0) {
    return invalid("the unit of heights is " + shown(options.height_unit_m) +
                   " m, and there are no heights apart from the positions; z is in metres");
  }
  return std::nullopt;
}

std::optional<Error> check_height_count(const PointsView& points) {
  if (!points.has_heights()) return std::nullopt;
  return check_height_count_of(points.heights_m(), points.size(), kPointsName);
}

std::optional<Error> check_heights(const PointsView& points) {
  if (!points.has_heights()) return std::nullopt;
  return check_heights_of(points.heights_m(), points.size(), kPointsName);
}

std::optional<Error> check_vertical(const PairOptions& options, const PointsView& points) {
  if (auto error = check_vertical(options, points.size(), points.has_heights())) return error;
  return check_heights(points);
}

std::optional<Error> check_vertical(const PairOptions& options, const PointsView& points,
                                    const PointsView& others) {
  const bool apart = points.has_heights() || others.has_heights();
  if (auto error = check_vertical(options, points.size() + others.size(), apart)) return error;
  if (!apart) return std::nullopt;
  if (auto error = check_heights_of(points.heights_m(), points.size(), kPointsName)) return error;
  return check_heights_of(others.heights_m(), others.size(), kOthersName);
}

std::optional<Error> check_no_heights(const PointsView& points, const char* name) {
  return check_no_heights(points.has_heights(), name);
}

std::optional<Error> check_no_heights(bool apart, const char* name) {
  if (!apart) return std::nullopt;
  Error error = invalid(
      "there are heights apart from the positions, which this search does not compare; give "
      "positions in space");
  error.location.array = name;
  return error;
}

std::optional<Error> check_size(std::size_t size) {
  if (size <= kMaxPoints) return std::nullopt;
  return Error{ErrorCode::kTooManyPoints,
               std::to_string(size) + " points, but ids have 32 bits: give at most " +
                   std::to_string(kMaxPoints) + " at a time",
               {}};
}

std::optional<Error> check_size(const PointsView& points) {
  std::optional<Error> error;
  if (points.fits()) {
    error = check_size(points.size());
  } else {
    const auto& [x, y, z] = points.lengths();
    error = invalid(std::to_string(x) + " numbers for x, " + std::to_string(y) + " for y and " +
                    std::to_string(z) + " for z; give as many for each axis");
  }
  if (error) error->location.array = kPointsName;
  return error;
}

bool in_domain(double coordinate) {
  const double magnitude = std::abs(coordinate);
  return magnitude <= kLargestCoordinate_m &&
         (magnitude >= kSmallestCoordinate_m || magnitude == 0.0);
}

std::optional<Error> check_points(const PointsView& points, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double value = points.coordinate(axis, i);
      if (in_domain(value)) continue;
      const std::string name(1, "xyz"[axis]);
      ErrorLocation location;
      location.array = kPointsName;
      location.record = i;
      if (!std::isfinite(value)) {
        return Error{ErrorCode::kNotFinite,
                     name + " is " + shown(value) + "; every coordinate must be a finite number",
                     location};
      }
      return Error{ErrorCode::kOutsideDomain,
                   name + " is " + shown(value) +
                       " m, outside the coordinate domain (0, or 3.9e-121 m to 2.6e+120 m in "
                       "magnitude); scale the coordinates",
                   location};
    }
  }
  return std::nullopt;
}

std::optional<Error> check_set(const PointsView& points, const char* name) {
  auto error = check_size(points);
  if (!error) error = check_points(points, 0, points.size());
  if (error) error->location.array = name;
  return error;
}

Error too_many_results(std::uint64_t most) {
  return Error{ErrorCode::kTooManyResults,
               "there are more than " + std::to_string(most) +
                   " results; raise max_results or lower the threshold",
               {}};
}

}  // namespace beespace::core
