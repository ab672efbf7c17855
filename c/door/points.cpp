#include "c/door/points.hpp"

#include "c/door/door.hpp"
#include "c/door/structs.hpp"

#include <beespace/point.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace beespace::c {

namespace {

// What a z that is not given reads, for each point.
template <class Number>
constexpr Number kZero = 0;

template <class Number>
Result<PointsView> view_of_numbers(const beespace_points& points, const char* name) {
  std::array axes = {static_cast<const Number*>(points.x), static_cast<const Number*>(points.y),
                     static_cast<const Number*>(points.z)};
  std::array<std::ptrdiff_t, 3> strides = {points.x_stride, points.y_stride, points.z_stride};
  if (axes[2] == nullptr) {
    axes[2] = &kZero<Number>;
    strides[2] = 0;
  }
  const auto count = static_cast<std::size_t>(points.count);
  // From a single point no stride leads anywhere, whatever it is.
  if (count == 1) strides = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axes[axis] == nullptr) return invalid("x or y is NULL, but there are points", name);
    if (!is_aligned(axes[axis]) ||
        strides[axis] % static_cast<std::ptrdiff_t>(alignof(Number)) != 0) {
      return invalid("coordinates are not aligned as their type is: copy them first", name);
    }
    const std::ptrdiff_t farthest = std::numeric_limits<std::ptrdiff_t>::max() / points.count;
    if (strides[axis] > farthest || strides[axis] < -farthest) {
      return invalid("a stride is so large that the last point is beyond all memory", name);
    }
  }
  return PointsView::strided(axes, count, strides);
}

std::string too_many(std::int64_t count) {
  return "there are " + std::to_string(count) + ", but ids have 32 bits: give at most " +
         std::to_string(kMaxPoints) + " at a time";
}

}  // namespace

Result<PointsView> view_of(const beespace_points* points, const char* name) {
  const Result<beespace_points> given = read_struct(points, name);
  if (!given) return given.error();
  if (given->count < 0) return invalid("count is below zero", name);
  // Before one is read: of a stride of 0 there may be any number.
  if (static_cast<std::uint64_t>(given->count) > kMaxPoints) {
    Error error{ErrorCode::kTooManyPoints, too_many(given->count), {}};
    error.location.array = name;
    return error;
  }
  if (given->type != BEESPACE_FLOAT64 && given->type != BEESPACE_FLOAT32) {
    return invalid("type is neither BEESPACE_FLOAT64 nor BEESPACE_FLOAT32", name);
  }
  if (given->count == 0) return PointsView();
  return given->type == BEESPACE_FLOAT32 ? view_of_numbers<float>(*given, name)
                                         : view_of_numbers<double>(*given, name);
}

Result<PointSets> sets_of(const beespace_points* points, const beespace_points* others) {
  Result<PointsView> first = view_of(points, "points");
  if (!first) return std::move(first).error();
  if (others == nullptr) return PointSets{*first, std::nullopt};
  Result<PointsView> second = view_of(others, "others");
  if (!second) return std::move(second).error();
  return PointSets{*first, *second};
}

}  // namespace beespace::c
