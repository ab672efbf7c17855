#include "cylinders/cylinder_rows.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace beespace::core {

namespace {

constexpr double kMostCells = 0x1p+20;  // along an axis

}  // namespace

class CylinderRows::Builder {
 public:
  Builder(CylinderRows& rows, const UprightPoints& points, const CylinderSize& size,
          const Resources& with)
      : rows_(rows), points_(points), with_(with) {
    measure();
    choose_axes();
    choose_cells(size);
  }

  // Sorted by cell along the row, then by row; within a cell as they come. Whether it is a crowd.
  bool distribute() {
    const std::size_t count = rows_.size_;
    Buffer<std::uint32_t> cell_of(with_.memory, count);
    Buffer<std::uint32_t> row_of(with_.memory, count);
    with_.crew.split(count, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) {
        const Upright place = points_[i];
        cell_of[i] = static_cast<std::uint32_t>(along_.of(place.at[axes_[0]]));
        row_of[i] = static_cast<std::uint32_t>(height_.of(place.height()) * across_.count() +
                                               across_.of(place.at[axes_[1]]));
      }
    });
    Buffer<std::uint32_t> sorted(with_.memory, count);
    Vector<std::uint32_t> next(along_.count() + 1, &with_.memory);
    for (std::size_t i = 0; i < count; ++i) ++next[cell_of[i] + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (std::size_t i = 0; i < count; ++i) {
      sorted[next[cell_of[i]]++] = static_cast<std::uint32_t>(i);
    }
    std::uint32_t* const begins = rows_.begins_.data();
    std::fill_n(begins, rows_.rows_ + 1, 0U);
    for (std::size_t i = 0; i < count; ++i) ++begins[row_of[i] + 1];
    std::partial_sum(begins, begins + rows_.rows_ + 1, begins);
    for (std::size_t k = 0; k < count; ++k) {
      rows_.order_[begins[row_of[sorted[k]]]++] = sorted[k];
    }
    std::copy_backward(begins, begins + rows_.rows_, begins + rows_.rows_ + 1);
    begins[0] = 0;
    return is_crowded(cell_of);
  }

  // In the order of their coordinates along each row. Points of earlier cells come first.
  void sort_and_fill() {
    with_.crew.split(rows_.rows_, [&](std::size_t first, std::size_t last, unsigned) {
      for (std::size_t row = first; row < last; ++row) {
        const std::size_t begin = rows_.begins_[row];
        const std::size_t end = rows_.begins_[row + 1];
        for (std::size_t slot = begin; slot < end; ++slot) insert(begin, slot);
      }
    });
  }

 private:
  // Cells along an axis: at least as wide as the threshold, and at most so many.
  class AxisCells {
   public:
    AxisCells() = default;
    AxisCells(double low, double high, double threshold, double most)
        : low_(low), width_(std::max(threshold * (1.0 + 0x1p-20), (high - low) / most)) {
      count_ = of(high) + 1;
    }
    [[nodiscard]] std::size_t of(double coordinate) const {
      return static_cast<std::size_t>((coordinate - low_) / width_);
    }
    [[nodiscard]] std::size_t count() const { return count_; }

   private:
    double low_ = 0.0;
    double width_ = 1.0;
    std::size_t count_ = 1;
  };

  void measure() {
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Upright place = points_[i];
      for (std::size_t axis = 0; axis < Upright::kAxes; ++axis) {
        low_[axis] = std::min(low_[axis], place.at[axis]);
        high_[axis] = std::max(high_[axis], place.at[axis]);
      }
    }
  }

  // Rows run along the widest horizontal axis, beside each other along the next.
  void choose_axes() {
    std::sort(axes_.begin(), axes_.end(), [&](std::size_t a, std::size_t b) {
      return high_[a] - low_[a] > high_[b] - low_[b];
    });
  }

  void choose_cells(const CylinderSize& size) {
    const auto points = static_cast<double>(points_.size());
    const auto cells = [&](std::size_t axis, double most) {
      return AxisCells(low_[axis], high_[axis], size.along(axis), std::min(most, kMostCells));
    };
    along_ = cells(axes_[0], std::max(4.0, points));
    // As many rows as there may be: fewer where the swarm is thin.
    const double most = std::clamp(4.0 * points, 4.0, 0x1p+31);
    across_ = cells(axes_[1], most);
    height_ = cells(0, most);
    const auto rows = [&] {
      return static_cast<double>(across_.count()) * static_cast<double>(height_.count());
    };
    if (rows() > most) {
      const double fewer = std::sqrt(most / rows());
      const auto across = static_cast<double>(across_.count());
      const auto height = static_cast<double>(height_.count());
      across_ = cells(axes_[1], std::max(1.0, across * fewer));
      height_ = cells(0, std::max(1.0, height * fewer));
    }
    rows_.across_ = across_.count();
    rows_.rows_ = across_.count() * height_.count();
    rows_.begins_ = Buffer<std::uint32_t>(with_.memory, rows_.rows_ + 1);
  }

  // The number of compared pairs is at most about 14 times the sum of the squares of the cells'
  // numbers of places: of a cell, the one ahead, and three each in four rows behind, by the
  // inequality of means.
  [[nodiscard]] bool is_crowded(const Buffer<std::uint32_t>& cell_of) const {
    std::uint64_t squares = 0;
    for (std::size_t row = 0; row < rows_.rows_; ++row) {
      const std::size_t end = rows_.begins_[row + 1];
      for (std::size_t begin = rows_.begins_[row]; begin < end;) {
        const std::uint32_t cell = cell_of[rows_.order_[begin]];
        std::size_t next = begin + 1;
        while (next < end && cell_of[rows_.order_[next]] == cell) ++next;
        squares += (next - begin) * (next - begin);
        begin = next;
      }
    }
    return squares > kMostExpected * rows_.size_;
  }

  void insert(std::size_t begin, std::size_t slot) {
    const std::uint32_t index = rows_.order_[slot];
    const Upright place = points_[index];
    const Place moved{place.at[axes_[0]], place.at[axes_[1]], place.at[axes_[2]], place.height()};
    std::size_t to = slot;
    for (; to > begin && rows_.places_[to - 1].along > moved.along; --to) {
      rows_.places_[to] = rows_.places_[to - 1];
      rows_.order_[to] = rows_.order_[to - 1];
    }
    rows_.places_[to] = moved;
    rows_.order_[to] = index;
  }

  static constexpr std::uint64_t kMostExpected = 8;

  CylinderRows& rows_;
  const UprightPoints& points_;
  const Resources& with_;
  std::array<double, Upright::kAxes> low_;
  std::array<double, Upright::kAxes> high_;
  std::array<std::size_t, 3> axes_{1, 2, 3};
  AxisCells along_;
  AxisCells across_;
  AxisCells height_;
};

CylinderRows::CylinderRows(const UprightPoints& points, const CylinderSize& size, bool wanted,
                           const Resources& with)
    : size_(points.size()),
      reach_(size.level),
      order_(with.memory, points.size()),
      places_(with.memory, points.size()) {
  Builder builder(*this, points, size, with);
  const bool crowded = builder.distribute();
  finished_ = wanted || !crowded;
  if (finished_) builder.sort_and_fill();
}

}  // namespace beespace::core
