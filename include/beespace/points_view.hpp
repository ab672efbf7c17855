// How beespace reads the caller's points: in place, whatever their layout, without a copy.
//
// A PointsView is three pointers to doubles, one per axis, and a stride in bytes for each; it
// serves arrays of structures, interleaved and separate coordinate arrays alike. It owns nothing:
// the memory must outlive the view and must not change while a search reads it. Cheap to copy.
//
// Arrays that do not fit together are an error, kInvalidArgument, of every question that they are
// given to: the view remembers what it was made of, and reads none of it beyond its end.
#pragma once

#include <beespace/point.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>

namespace beespace {

class PointsView;

namespace detail {
template <class T>
concept SpanOfPoints =
    std::convertible_to<const T&, std::span<const Point>> && !std::same_as<T, PointsView>;
}  // namespace detail

class PointsView {
 public:
  constexpr PointsView() = default;

  // Points one after the other: std::span<const Point>, std::vector<Point>, std::array<Point, N>.
  // As a function's argument a temporary vector is fine; a view that is kept must not outlive it.
  template <detail::SpanOfPoints Points>
  constexpr PointsView(const Points& points)  // NOLINT(google-explicit-constructor): a view
      : PointsView(std::span<const Point>(points), FromSpan{}) {}

  // x0 y0 z0 x1 y1 z1 ...: `xyz.size() / 3` points; doubles that are left over do not fit.
  static PointsView interleaved(std::span<const double> xyz) {
    constexpr auto kStride = static_cast<std::ptrdiff_t>(3 * sizeof(double));
    PointsView view = strided(xyz.data(), xyz.data() + 1, xyz.data() + 2, xyz.size() / 3, kStride);
    view.lengths_ = {(xyz.size() + 2) / 3, (xyz.size() + 1) / 3, xyz.size() / 3};
    return view;
  }

  // One array per axis, all of one length. (Of others, the view is as long as the shortest.)
  static PointsView separate(std::span<const double> x, std::span<const double> y,
                             std::span<const double> z) {
    const std::size_t shorter = x.size() < y.size() ? x.size() : y.size();
    const std::size_t size = shorter < z.size() ? shorter : z.size();
    PointsView view = strided(x.data(), y.data(), z.data(), size, sizeof(double));
    view.lengths_ = {x.size(), y.size(), z.size()};
    return view;
  }

  // The first point's three coordinates, and the distance in bytes from one point to the next
  // (for example sizeof(MyBee)). A stride may be negative; a stride of 0 repeats a coordinate.
  // Every coordinate must be aligned as doubles are: packed structures must be copied first.
  static PointsView strided(const double* x, const double* y, const double* z, std::size_t size,
                            std::ptrdiff_t stride_bytes) {
    return strided({x, y, z}, size, {stride_bytes, stride_bytes, stride_bytes});
  }

  static PointsView strided(std::array<const double*, 3> axes, std::size_t size,
                            std::array<std::ptrdiff_t, 3> stride_bytes) {
    PointsView view;
    view.axes_ = axes;
    view.stride_bytes_ = stride_bytes;
    view.size_ = size;
    view.lengths_ = {size, size, size};
    return view;
  }

  // How many numbers were given for each axis, and whether they are as many.
  [[nodiscard]] constexpr const std::array<std::size_t, 3>& lengths() const { return lengths_; }
  [[nodiscard]] constexpr bool fits() const {
    return lengths_[0] == size_ && lengths_[1] == size_ && lengths_[2] == size_;
  }

  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }

  // Coordinate `axis` (0, 1 or 2) of point `index`; both unchecked.
  [[nodiscard]] double coordinate(std::size_t axis, std::size_t index) const {
    const auto* bytes = reinterpret_cast<const std::byte*>(axes_[axis]);
    return *reinterpret_cast<const double*>(bytes + static_cast<std::ptrdiff_t>(index) *
                                                        stride_bytes_[axis]);
  }

  [[nodiscard]] Point operator[](std::size_t index) const {
    return {coordinate(0, index), coordinate(1, index), coordinate(2, index)};
  }

  [[nodiscard]] constexpr const std::array<const double*, 3>& axes() const { return axes_; }
  [[nodiscard]] constexpr const std::array<std::ptrdiff_t, 3>& stride_bytes() const {
    return stride_bytes_;
  }

 private:
  struct FromSpan {};
  constexpr PointsView(std::span<const Point> points, FromSpan)
      : size_(points.size()), lengths_{points.size(), points.size(), points.size()} {
    if (points.empty()) return;
    axes_ = {&points.front().x, &points.front().y, &points.front().z};
    stride_bytes_ = {sizeof(Point), sizeof(Point), sizeof(Point)};
  }

  std::array<const double*, 3> axes_{};
  std::array<std::ptrdiff_t, 3> stride_bytes_{};
  std::size_t size_ = 0;
  std::array<std::size_t, 3> lengths_{};
};

}  // namespace beespace
