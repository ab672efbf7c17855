#include "tree/middle_of_shell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace beespace::core {

namespace {

constexpr std::size_t kUnknowns = 4;  // |p|^2 = 2 c p + w

// Of each unknown its equation; the last column is what it shall be.
using Equations = std::array<std::array<double, kUnknowns + 1>, kUnknowns>;

// Gaussian elimination with pivots; false where the equations have no single solution.
bool solve(Equations& rows) {
  for (std::size_t column = 0; column < kUnknowns; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < kUnknowns; ++row) {
      if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
    }
    std::swap(rows[column], rows[pivot]);
    if (std::abs(rows[column][column]) < 1e-12) return false;
    for (std::size_t row = 0; row < kUnknowns; ++row) {
      if (row == column) continue;
      const double factor = rows[row][column] / rows[column][column];
      for (std::size_t i = column; i <= kUnknowns; ++i) rows[row][i] -= factor * rows[column][i];
    }
  }
  return true;
}

}  // namespace

std::optional<Point> middle_of_shell(const PointsView& points, const Point& near) {
  constexpr std::size_t kMostDrawn = 512;
  const std::size_t drawn = std::min(points.size(), kMostDrawn);
  const auto seen = [&](std::size_t i) {
    const Point p = points[points.size() * i / drawn];
    return std::array<double, kUnknowns>{p.x - near.x, p.y - near.y, p.z - near.z, 1.0};
  };
  double reach = 0.0;
  for (std::size_t i = 0; i < drawn; ++i) {
    const auto at = seen(i);
    reach = std::max({reach, std::abs(at[0]), std::abs(at[1]), std::abs(at[2])});
  }
  if (reach == 0.0) return std::nullopt;
  Equations rows{};
  for (std::size_t i = 0; i < drawn; ++i) {
    auto at = seen(i);
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] /= reach;
    const double squared = at[0] * at[0] + at[1] * at[1] + at[2] * at[2];
    for (std::size_t row = 0; row < kUnknowns; ++row) {
      for (std::size_t column = 0; column < kUnknowns; ++column) {
        rows[row][column] += at[row] * at[column];
      }
      rows[row][kUnknowns] += at[row] * squared;
    }
  }
  if (!solve(rows)) return std::nullopt;
  std::array<double, 3> centre{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    centre[axis] = rows[axis][kUnknowns] / rows[axis][axis] / 2.0;
    if (!(std::abs(centre[axis]) <= 1.0)) return std::nullopt;
  }
  return Point{near.x + centre[0] * reach, near.y + centre[1] * reach, near.z + centre[2] * reach};
}

}  // namespace beespace::core
