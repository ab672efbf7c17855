/// @file
/// @brief How beespace reads the caller's points: in place, whatever their layout, without a copy.
#pragma once

#include <beespace/lifetimebound.hpp>
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

// A span may die before what it refers to; a container may not. (<span> declares the variable; all
// of <ranges> costs every reader of this header.)
template <class T>
concept Container = !std::ranges::enable_borrowed_range<T>;
template <class T>
concept ContainerOfNumbers = Container<T> &&
    (std::convertible_to<const T&, std::span<const double>> ||
     std::convertible_to<const T&, std::span<const float>>);

// A container of them as a span.
template <ContainerOfNumbers T>
constexpr auto span_of(const T& numbers) {
  if constexpr (std::convertible_to<const T&, std::span<const double>>) {
    return std::span<const double>(numbers);
  } else {
    return std::span<const float>(numbers);
  }
}

}  // namespace detail

/// @brief A view of points in the caller's memory: three pointers to doubles or to floats, one per
/// axis, and a stride in bytes for each.
///
/// It serves arrays of structures, interleaved and separate coordinate arrays alike. A float is
/// converted to double when it is read, which is exact: the answers are those for the values of the
/// floats. Arrays that do not fit together are an error, ErrorCode::kInvalidArgument, of every
/// function that the view is given to: the view remembers what it was made of, and reads none of it
/// beyond its end.
///
/// Ownership: none; the memory must outlive the view and must not change while a search reads it,
/// or the search is undefined: it reads coordinates more than once. Cheap to copy.
class PointsView {
 public:
  /// @brief A view of no points.
  constexpr PointsView() = default;

  /// @brief A view of points one after the other: std::span<const Point>, std::vector<Point>,
  /// std::array<Point, N>.
  ///
  /// As a function's argument a temporary vector is fine; a view that is kept must not outlive it.
  ///
  /// @param points The points; must outlive the view.
  template <detail::SpanOfPoints Points>
  constexpr PointsView(const Points& points)  // NOLINT(google-explicit-constructor): a view
      : PointsView(std::span<const Point>(points), FromSpan{}) {}

  /// @brief The same of a container, for which a compiler may warn where the view outlives it.
  /// @param points The points; must outlive the view.
  template <detail::SpanOfPoints Points>
  requires detail::Container<Points>
  constexpr PointsView(  // NOLINT(google-explicit-constructor): a view
      const Points& points BEESPACE_LIFETIMEBOUND)
      : PointsView(std::span<const Point>(points), FromSpan{}) {}

  /// @brief A view of interleaved coordinates: x0 y0 z0 x1 y1 z1 ...
  /// @param xyz The coordinates in metres; must outlive the view.
  /// @return A view of `xyz.size() / 3` points; coordinates that are left over do not fit.
  static PointsView interleaved(std::span<const double> xyz) { return interleaved_of(xyz); }
  /// @brief The same of floats.
  /// @param xyz The coordinates in metres; must outlive the view.
  /// @return The view.
  static PointsView interleaved(std::span<const float> xyz) { return interleaved_of(xyz); }
  /// @brief The same of a container of doubles or floats, for which a compiler may warn where the
  /// view outlives it.
  /// @param xyz The coordinates in metres; must outlive the view.
  /// @return The view.
  template <detail::ContainerOfNumbers Numbers>
  static PointsView interleaved(const Numbers& xyz BEESPACE_LIFETIMEBOUND) {
    return interleaved_of(detail::span_of(xyz));
  }

  /// @brief A view of one array per axis, all of one length.
  /// @param x The first coordinates in metres; must outlive the view.
  /// @param y The second coordinates in metres; must outlive the view.
  /// @param z The third coordinates in metres; must outlive the view.
  /// @return The view. (Where the lengths differ, it is as long as the shortest, and does not fit.)
  static PointsView separate(std::span<const double> x, std::span<const double> y,
                             std::span<const double> z) {
    return separate_of(x, y, z);
  }
  /// @brief The same of floats.
  /// @param x The first coordinates in metres; must outlive the view.
  /// @param y The second coordinates in metres; must outlive the view.
  /// @param z The third coordinates in metres; must outlive the view.
  /// @return The view.
  static PointsView separate(std::span<const float> x, std::span<const float> y,
                             std::span<const float> z) {
    return separate_of(x, y, z);
  }
  /// @brief The same of containers of doubles or floats, for which a compiler may warn where the
  /// view outlives them.
  /// @param x The first coordinates in metres; must outlive the view.
  /// @param y The second coordinates in metres; must outlive the view.
  /// @param z The third coordinates in metres; must outlive the view.
  /// @return The view.
  template <detail::ContainerOfNumbers Numbers>
  static PointsView separate(const Numbers& x BEESPACE_LIFETIMEBOUND,
                             const Numbers& y BEESPACE_LIFETIMEBOUND,
                             const Numbers& z BEESPACE_LIFETIMEBOUND) {
    return separate_of(detail::span_of(x), detail::span_of(y), detail::span_of(z));
  }

  /// @brief A view of points at equal distances in memory, as members of larger structures are.
  ///
  /// Each coordinate must be aligned as doubles are: packed structures must be copied first.
  ///
  /// @param x The first coordinate of the first point, in metres.
  /// @param y The second coordinate of the first point, in metres.
  /// @param z The third coordinate of the first point, in metres.
  /// @param size How many points there are.
  /// @param stride_bytes The distance in bytes from one point to the next (for example
  ///   sizeof(MyBee)). It may be negative; 0 repeats a coordinate.
  /// @return The view.
  static PointsView strided(const double* x, const double* y, const double* z, std::size_t size,
                            std::ptrdiff_t stride_bytes) {
    return strided_of<double>({x, y, z}, size, {stride_bytes, stride_bytes, stride_bytes});
  }
  /// @brief The same of floats, which must be aligned as floats are.
  /// @param x The first coordinate of the first point, in metres.
  /// @param y The second coordinate of the first point, in metres.
  /// @param z The third coordinate of the first point, in metres.
  /// @param size How many points there are.
  /// @param stride_bytes The distance in bytes from one point to the next.
  /// @return The view.
  static PointsView strided(const float* x, const float* y, const float* z, std::size_t size,
                            std::ptrdiff_t stride_bytes) {
    return strided_of<float>({x, y, z}, size, {stride_bytes, stride_bytes, stride_bytes});
  }

  /// @brief The same with a stride of its own for each axis.
  /// @param axes The three coordinates of the first point, in metres.
  /// @param size How many points there are.
  /// @param stride_bytes For each axis the distance in bytes from one point to the next.
  /// @return The view.
  static PointsView strided(std::array<const double*, 3> axes, std::size_t size,
                            std::array<std::ptrdiff_t, 3> stride_bytes) {
    return strided_of<double>(axes, size, stride_bytes);
  }
  /// @brief The same of floats.
  /// @param axes The three coordinates of the first point, in metres.
  /// @param size How many points there are.
  /// @param stride_bytes For each axis the distance in bytes from one point to the next.
  /// @return The view.
  static PointsView strided(std::array<const float*, 3> axes, std::size_t size,
                            std::array<std::ptrdiff_t, 3> stride_bytes) {
    return strided_of<float>(axes, size, stride_bytes);
  }

  /// @brief A view of the same points with heights that are kept apart from their positions: for a
  /// vertical threshold (SearchOptions::vertical_m) between points whose third axis is not the
  /// height.
  ///
  /// Positions are then horizontal: of geographic ones, those brought to height 0 (see to_ecef).
  /// The straight line between two points is that of their positions and heights: the root of the
  /// sum of the squares of both distances. Between two sets, both have such heights, or none has.
  ///
  /// @param heights_m One height for each point, in metres or SearchOptions::height_unit_m; must
  ///   outlive the view. A search returns ErrorCode::kInvalidArgument where there are more or fewer
  ///   of them, and where it has no vertical threshold to compare them with.
  /// @return The view.
  [[nodiscard]] PointsView with_heights(std::span<const double> heights_m) const {
    PointsView view = *this;
    view.heights_m_ = heights_m;
    return view;
  }
  /// @brief The same of a container, for which a compiler may warn where the view outlives it.
  /// @param heights_m One height for each point; must outlive the view.
  /// @return The view.
  template <detail::Container Heights>
  requires std::convertible_to<const Heights&, std::span<const double>>
  [[nodiscard]] PointsView with_heights(const Heights& heights_m BEESPACE_LIFETIMEBOUND) const {
    return with_heights(std::span<const double>(heights_m));
  }

  /// @brief Says whether heights are kept apart from positions.
  /// @return Whether with_heights() gave any.
  [[nodiscard]] constexpr bool has_heights() const { return !heights_m_.empty(); }
  /// @brief Gives the heights that are kept apart.
  /// @return One for each point, or none.
  [[nodiscard]] constexpr std::span<const double> heights_m() const { return heights_m_; }

  /// @brief A view of the same points with their axes in another order.
  /// @param order Which axis of this is axis 0, 1 and 2 of the result.
  /// @return The view.
  [[nodiscard]] PointsView with_axes(const std::array<std::size_t, 3>& order) const {
    PointsView view = *this;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      view.axes_[axis] = axes_[order[axis]];
      view.stride_bytes_[axis] = stride_bytes_[order[axis]];
      view.lengths_[axis] = lengths_[order[axis]];
    }
    return view;
  }

  /// @brief Says how many numbers were given for each axis.
  /// @return Three counts.
  [[nodiscard]] constexpr const std::array<std::size_t, 3>& lengths() const BEESPACE_LIFETIMEBOUND {
    return lengths_;
  }
  /// @brief Says whether as many numbers were given for each axis.
  /// @return Whether the arrays fit together.
  [[nodiscard]] constexpr bool fits() const {
    return lengths_[0] == size_ && lengths_[1] == size_ && lengths_[2] == size_;
  }

  /// @brief Says how many points there are.
  /// @return The number of points.
  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  /// @brief Says whether there are no points.
  /// @return Whether size() is 0.
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }

  /// @brief Reads one coordinate.
  /// @param axis 0, 1 or 2; unchecked.
  /// @param index The index of the point; unchecked.
  /// @return The coordinate in metres.
  [[nodiscard]] double coordinate(std::size_t axis, std::size_t index) const {
    const std::byte* const at = static_cast<const std::byte*>(axes_[axis]) +
                                static_cast<std::ptrdiff_t>(index) * stride_bytes_[axis];
    if (floats_) return static_cast<double>(*reinterpret_cast<const float*>(at));
    return *reinterpret_cast<const double*>(at);
  }

  /// @brief Reads one point.
  /// @param index The index of the point; unchecked.
  /// @return A copy of it.
  [[nodiscard]] Point operator[](std::size_t index) const {
    return {coordinate(0, index), coordinate(1, index), coordinate(2, index)};
  }

  /// @brief Says whether the coordinates are floats.
  /// @return False when they are doubles.
  [[nodiscard]] constexpr bool holds_floats() const { return floats_; }
  /// @brief Gives the pointers of the view.
  /// @return Where the three coordinates of the first point are: floats or doubles, as
  /// holds_floats()
  ///   says.
  [[nodiscard]] constexpr const std::array<const void*, 3>& axes() const BEESPACE_LIFETIMEBOUND {
    return axes_;
  }
  /// @brief Gives the strides of the view.
  /// @return For each axis the distance in bytes from one point to the next.
  [[nodiscard]] constexpr const std::array<std::ptrdiff_t, 3>& stride_bytes() const
      BEESPACE_LIFETIMEBOUND {
    return stride_bytes_;
  }

 private:
  template <class Number>
  static PointsView strided_of(const std::array<const Number*, 3>& axes, std::size_t size,
                               const std::array<std::ptrdiff_t, 3>& stride_bytes) {
    PointsView view;
    view.axes_ = {axes[0], axes[1], axes[2]};
    view.stride_bytes_ = stride_bytes;
    view.size_ = size;
    view.lengths_ = {size, size, size};
    view.floats_ = std::same_as<Number, float>;
    return view;
  }

  template <class Number>
  static PointsView interleaved_of(std::span<const Number> xyz) {
    constexpr auto kStride = static_cast<std::ptrdiff_t>(3 * sizeof(Number));
    // Of no point there may be no array either.
    const Number* const x = xyz.data();
    const std::size_t next = xyz.size() < 3 ? 0 : 1;
    PointsView view = strided(x, x + next, x + 2 * next, xyz.size() / 3, kStride);
    view.lengths_ = {(xyz.size() + 2) / 3, (xyz.size() + 1) / 3, xyz.size() / 3};
    return view;
  }

  template <class Number>
  static PointsView separate_of(std::span<const Number> x, std::span<const Number> y,
                                std::span<const Number> z) {
    const std::size_t shorter = x.size() < y.size() ? x.size() : y.size();
    const std::size_t size = shorter < z.size() ? shorter : z.size();
    PointsView view = strided(x.data(), y.data(), z.data(), size, sizeof(Number));
    view.lengths_ = {x.size(), y.size(), z.size()};
    return view;
  }

  struct FromSpan {};
  constexpr PointsView(std::span<const Point> points, FromSpan)
      : size_(points.size()), lengths_{points.size(), points.size(), points.size()} {
    if (points.empty()) return;
    axes_ = {&points.front().x, &points.front().y, &points.front().z};
    stride_bytes_ = {sizeof(Point), sizeof(Point), sizeof(Point)};
  }

  std::array<const void*, 3> axes_{};
  std::array<std::ptrdiff_t, 3> stride_bytes_{};
  std::size_t size_ = 0;
  std::array<std::size_t, 3> lengths_{};
  bool floats_ = false;
  std::span<const double> heights_m_;
};

}  // namespace beespace
