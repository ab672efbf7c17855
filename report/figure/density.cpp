#include "report/figure/density.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::report {
namespace {

std::size_t cells_along(double length, double side) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length / side - 1e-9)));
}

std::size_t index_along(double from_corner, double side, std::size_t count) {
  const double last = static_cast<double>(count - 1);
  return static_cast<std::size_t>(std::clamp(std::floor(from_corner / side), 0.0, last));
}

}  // namespace

Density::Density(Spot corner, double width, double height, double side)
    : corner_(corner),
      side_(side),
      columns_(cells_along(width, side)),
      rows_(cells_along(height, side)),
      counts_(columns_ * rows_) {
}

std::size_t Density::cell_of(Spot spot) const {
  return index_along(spot.y - corner_.y, side_, rows_) * columns_ +
         index_along(spot.x - corner_.x, side_, columns_);
}

void Density::add(Spot spot) {
  ++counts_[cell_of(spot)];
}

void Density::add_way(Spot from, Spot to) {
  // Steps of less than half a cell miss no more than corners.
  const int steps =
      static_cast<int>(std::ceil(2.5 * std::hypot(to.x - from.x, to.y - from.y) / side_)) + 1;
  std::size_t last = counts_.size();
  for (int k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const std::size_t cell =
        cell_of({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
    if (cell != last) ++counts_[cell];
    last = cell;
  }
}

std::uint32_t Density::most() const {
  return *std::max_element(counts_.begin(), counts_.end());
}

Cells Density::cells(std::vector<Ink> inks) const {
  const double most_log = std::log(std::max(2.0, static_cast<double>(most())));
  const auto shades = static_cast<double>(inks.size());
  Cells cells{corner_, side_, columns_, {}, std::move(inks)};
  cells.levels.reserve(counts_.size());
  for (const std::uint32_t count : counts_) {
    const double share = count > 0 ? std::log(static_cast<double>(count)) / most_log : 0.0;
    const double level = count > 0 ? 1.0 + std::min(shades - 1.0, std::floor(share * shades)) : 0.0;
    cells.levels.push_back(static_cast<std::uint8_t>(level));
  }
  return cells;
}

Diamonds Density::diamonds(Ink ink) const {
  constexpr double kLeast = 2.2;
  const double greatest = 0.36 * side_;
  const double most_of_all = most();
  Diamonds diamonds{{}, ink};
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (counts_[i] == 0) continue;
    const std::size_t row = i / columns_;
    const std::size_t column = i % columns_;
    const Spot centre{corner_.x + (static_cast<double>(column) + 0.5) * side_,
                      corner_.y + (static_cast<double>(row) + 0.5) * side_};
    const double radius = greatest * std::sqrt(counts_[i] / most_of_all);
    diamonds.marks.push_back({centre, std::max(kLeast, radius)});
  }
  return diamonds;
}

}  // namespace beespace::report
